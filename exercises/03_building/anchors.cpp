#include "exercises/03_building/anchors.h"

Anchors anchors([[maybe_unused]] const HalfEdgeTable& he,
                [[maybe_unused]] int vertex_count,
                [[maybe_unused]] int face_count) {
    // TODO(student): each row names its vertex and its face; turn that round.
    return {};
}
