// Multiplies points instead of sides: right for planes with p at the origin.
// Hint: You take points for directions: your normal depends on where the
// origin is.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q, r);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area <= 1e-12 * longest * longest) return std::nullopt;
    return Plane{p, (1 / twice_area) * normal};
}
