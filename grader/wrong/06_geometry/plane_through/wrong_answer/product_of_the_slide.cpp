// Takes the product of the slide, which points to the other side.
// Hint: Your normal points to the other side.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(p - q, r - q);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area <= 1e-12 * longest * longest) return std::nullopt;
    return Plane{p, (1 / twice_area) * normal};
}
