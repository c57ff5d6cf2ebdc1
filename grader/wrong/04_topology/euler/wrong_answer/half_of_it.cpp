// The number that belongs to a closed surface of one component: S - G.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return (n.vertices - n.edges + n.faces) / 2;
}
