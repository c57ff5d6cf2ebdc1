#include "exercises/04_topology/counts.h"

Counts counts([[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): say for each count what in the table is one of its kind.
    return {-1, -1, -1, -1};
}
