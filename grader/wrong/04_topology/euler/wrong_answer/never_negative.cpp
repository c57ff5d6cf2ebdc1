// Takes a negative characteristic for a mistake.
// Hint: You never give a number below 0; it may be negative.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    int chi = n.vertices - n.edges + n.faces;
    return chi < 0 ? 0 : chi;
}
