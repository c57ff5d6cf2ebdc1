// The equation of closed meshes, on any mesh.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int s = components(he);
    return (2 * s - chi) / 2;
}
