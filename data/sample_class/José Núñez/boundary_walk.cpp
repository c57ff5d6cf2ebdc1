#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk([[maybe_unused]] const HalfEdgeTable& he,
                               [[maybe_unused]] int i) {
    // TODO(student): get to the side without a face, then go once round it.
    return {-1};
}
