// Says 1 when there is any handle.
// Hint: You are right where there is no handle, and wrong where there
// are several.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return (2 * s - chi - b) / 2 > 0 ? 1 : 0;
}
