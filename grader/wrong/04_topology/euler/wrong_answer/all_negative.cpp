// The sign of the faces is wrong.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return n.vertices - n.edges - n.faces;
}
