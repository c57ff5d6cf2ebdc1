#include "exercises/06_geometry/vertex_normal.h"

Vec3 vertex_normal([[maybe_unused]] const HalfEdgeTable& he,
                   [[maybe_unused]] std::span<const Vec3> positions,
                   [[maybe_unused]] int i, [[maybe_unused]] Weight weight) {
    // TODO(student): walk round the vertex and take the mean of its normals.
    return {2, 2, 2};
}
