// Multiplies by the matrix itself.
// Hint: You transform the normal like a point: right for rotations only.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = m * n;
    return (1 / length(normal)) * normal;
}
