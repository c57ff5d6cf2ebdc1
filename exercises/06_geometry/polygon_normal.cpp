#include "exercises/06_geometry/polygon_normal.h"

Vec3 polygon_normal([[maybe_unused]] const HalfEdgeTable& he,
                    [[maybe_unused]] std::span<const Vec3> positions,
                    [[maybe_unused]] int i) {
    // TODO(student): go round the face and add up what each wedge says.
    return {1, 1, 1};
}
