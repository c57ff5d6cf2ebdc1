#include "exercises/02_border/boundary_loops.h"

std::vector<std::vector<int>> boundary_loops(
    [[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): walk every loop, but each of them only once.
    return {std::vector<int>{-1}};
}
