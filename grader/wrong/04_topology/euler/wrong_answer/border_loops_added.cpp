// Counts a border loop as a face, as if all holes were closed.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/euler.h"

int euler(const HalfEdgeTable& he) {
    Counts n = counts(he);
    return n.vertices - n.edges + n.faces + n.border_loops;
}
