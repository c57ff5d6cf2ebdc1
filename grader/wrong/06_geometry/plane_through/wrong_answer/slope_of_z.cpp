// Solves for z = ax + by + c: no plane may be upright.
// Hint: You are wrong about planes that stand upright.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>
#include <cmath>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q - p, r - p);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    if (twice_area <= 1e-12 * longest * longest) return std::nullopt;
    if (std::abs(normal.z) < 1e-12 * twice_area) return std::nullopt;
    return Plane{p, (1 / twice_area) * normal};
}
