// Counts the holes with a rim, too.
// Hint: You are right on closed meshes; where there is a border, its loops do
// not go into your number as they should.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return (2 * s - chi - b) / 2 + (b > s ? b - s : 0);
}
