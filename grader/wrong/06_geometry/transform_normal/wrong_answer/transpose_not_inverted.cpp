// Multiplies by the transpose.
// Hint: You are wrong even for rotations: you turn the normal back.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = n.x * a + n.y * b + n.z * c;
    return (1 / length(normal)) * normal;
}
