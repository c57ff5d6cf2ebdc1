#include "exercises/06_geometry/plane_through.h"

std::optional<Plane> plane_through([[maybe_unused]] Vec3 p,
                                   [[maybe_unused]] Vec3 q,
                                   [[maybe_unused]] Vec3 r) {
    // TODO(student): find a direction at right angles to two others.
    return Plane();
}
