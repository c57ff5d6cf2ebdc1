// Forgets to divide by two.
// Hint: You are right where there is no handle, and wrong where there
// are several.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return 2 * s - chi - b;
}
