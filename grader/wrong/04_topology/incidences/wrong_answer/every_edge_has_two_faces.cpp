// Does not think of the border.
// Hint: You are right where there is no border, and wrong at every border.
#include "exercises/04_topology/incidences.h"

Incidences incidences(const HalfEdgeTable& he) {
    return {he.size(), he.size(), he.size()};
}
