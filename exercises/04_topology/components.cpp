#include "exercises/04_topology/components.h"

int components([[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): start a search from each vertex that no search has
    // reached.
    return -1;
}
