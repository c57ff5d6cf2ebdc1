// The name of the function for the name of the number.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return n.vertices - n.edges + n.faces + 0 * euler(he);
}
