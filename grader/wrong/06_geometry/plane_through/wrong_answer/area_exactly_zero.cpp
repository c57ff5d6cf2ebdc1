// Refuses an area of exactly 0 only: rounding leaves some.
// Hint: You give a plane also where the three points do not fix one.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q - p, r - p);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area == 0) return std::nullopt;
    return Plane{p, (1 / twice_area) * normal};
}
