// The equation of closed meshes, on any mesh.
// Hint: You are right on closed meshes; where there is a border, its loops do
// not go into your number as they should.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int s = components(he);
    return (2 * s - chi) / 2;
}
