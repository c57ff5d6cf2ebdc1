// Divides by zero where the triangle is degenerate.
// Hint: You give a vector also where there is no normal.
#include "exercises/06_geometry/face_normal.h"

std::optional<Vec3> face_normal(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = area_vector(a, b, c);
    return (1 / length(n)) * n;
}
