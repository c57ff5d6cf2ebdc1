// Gives a plane without a normal where there is none.
// Hint: You give a plane also where the three points do not fix one.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q - p, r - p);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area <= 1e-12 * longest * longest) return Plane{p, {}};
    return Plane{p, (1 / twice_area) * normal};
}
