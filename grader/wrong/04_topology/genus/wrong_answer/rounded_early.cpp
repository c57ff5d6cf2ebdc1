// Divides the characteristic alone: right where B is even.
// Hint: You divide before you have added everything, and lose a half.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return s - (chi + 1) / 2 - b / 2;
}
