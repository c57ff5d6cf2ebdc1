// Compares the area with a fixed number: it depends on the unit of length.
// Hint: You let the unit of length decide whether there is a normal.
#include "exercises/06_geometry/face_normal.h"

std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = area_vector(a, b, c);
    if (length(n) <= 1e-12) return std::nullopt;
    return (1 / length(n)) * n;
}
