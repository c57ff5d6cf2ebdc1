// Forgets to bring it to unit length.
// Hint: Your normal has the right direction, but its length is not 1.
#include "exercises/06_geometry/face_normal.h"

#include <algorithm>

std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = area_vector(a, b, c);
    double longest = std::max({length(b - a), length(c - b), length(a - c)});
    if (length(n) <= 1e-12 * longest * longest) return std::nullopt;
    return n;
}
