// Leaves S at 1.
#include "exercises/04_topology/genus.h"

int genus(const HalfEdgeTable& he) {
    int chi = euler(he);
    int b = counts(he).border_loops;
    return (2 - chi - b) / 2;
}
