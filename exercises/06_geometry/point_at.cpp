#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at([[maybe_unused]] const Line& line,
                             [[maybe_unused]] double t) {
    // TODO(student): go t times along the direction, if t may be that.
    return Vec3{-1, -1, -1};
}
