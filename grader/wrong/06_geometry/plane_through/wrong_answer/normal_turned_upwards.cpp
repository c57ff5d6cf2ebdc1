// Turns the normal so that z is positive.
// Hint: You turn normals that point down.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q - p, r - p);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area <= 1e-12 * longest * longest) return std::nullopt;
    if (normal.z < 0) normal = -1 * normal;
    return Plane{p, (1 / twice_area) * normal};
}
