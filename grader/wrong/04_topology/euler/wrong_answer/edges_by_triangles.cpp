// Works the edges out from the faces, as if all were triangles.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return n.vertices - 3 * n.faces / 2 + n.faces;
}
