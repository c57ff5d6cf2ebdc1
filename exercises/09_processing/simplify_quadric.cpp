#include "exercises/09_processing/simplify_quadric.h"

HalfEdgeTable simplify_quadric([[maybe_unused]] const HalfEdgeTable& he,
                               [[maybe_unused]] std::span<const Vec3> positions,
                               [[maybe_unused]] int faces) {
    // TODO(student): let each vertex remember the planes that it must stay
    // near.
    return HalfEdgeTable();
}
