#include "exercises/09_processing/simplify.h"

HalfEdgeTable simplify([[maybe_unused]] const HalfEdgeTable& he,
                       [[maybe_unused]] std::span<const Vec3> positions,
                       [[maybe_unused]] int faces) {
    // TODO(student): choose an edge, collapse it, and begin again.
    return HalfEdgeTable();
}
