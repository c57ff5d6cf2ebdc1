// The genus of a component on average.
// Hint: You are right for one component, and wrong for several.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return s == 0 ? 0 : (2 * s - chi - b) / 2 / s;
}
