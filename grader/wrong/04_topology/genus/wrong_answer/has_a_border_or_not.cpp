// Takes for B whether there is a border.
// Hint: You are right on closed meshes; where there is a border, its loops do
// not go into your number as they should.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops > 0 ? 1 : 0;
    int s = components(he);
    return (2 * s - chi - b) / 2;
}
