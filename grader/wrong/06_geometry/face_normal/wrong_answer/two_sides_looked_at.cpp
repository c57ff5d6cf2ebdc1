// Forgets the third side when it looks for the longest.
// Hint: You give a normal to triangles that are too thin to have one, at least
// for some orders of their corners.
#include "exercises/06_geometry/face_normal.h"

#include <algorithm>

std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = area_vector(a, b, c);
    double longest = std::max(length(b - a), length(c - b));
    if (length(n) <= 1e-12 * longest * longest) return std::nullopt;
    return (1 / length(n)) * n;
}
