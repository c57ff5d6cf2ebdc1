// Edges that meet at b, in the wrong order: it points to the back.
// Hint: Your normal points to the other side.
#include "exercises/06_geometry/face_normal.h"

#include <algorithm>

std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = cross(a - b, c - b);
    double longest = std::max({length(b - a), length(c - b), length(a - c)});
    if (length(n) <= 1e-12 * longest * longest) return std::nullopt;
    return (1 / length(n)) * n;
}
