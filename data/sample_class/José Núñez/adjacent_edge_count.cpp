#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count([[maybe_unused]] const HalfEdgeTable& he,
                        [[maybe_unused]] int i) {
    // TODO(student): walk round the face and look across each side.
    return -1;
}
