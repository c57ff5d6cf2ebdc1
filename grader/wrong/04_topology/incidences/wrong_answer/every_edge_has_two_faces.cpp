// Does not think of the border.
#include "exercises/04_topology/incidences.h"

Incidences incidences(const HalfEdgeTable& he) {
    return {he.size(), he.size(), he.size()};
}
