// Works out the mean first: an empty table has no component to divide by.
// Hint: You divide by a number that is 0 for an empty table.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    int s = components(he);
    return (2 * s - chi - b) / s * s / 2;
}
