// Divides each number by two: 1 / 2 is 0, twice.
// Hint: You are right on closed meshes; where there is a border, its loops do
// not go into your number as they should.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return s - chi / 2 - b / 2;
}
