// Multiplies by the inverse: right for scalings, not for turns.
// Hint: You have rows and columns mixed up: right for scalings, but not for
// rotations.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 x = cofactors.rows[0], y = cofactors.rows[1], z = cofactors.rows[2];
    Mat3 inverse{
        {Vec3{x.x, y.x, z.x}, Vec3{x.y, y.y, z.y}, Vec3{x.z, y.z, z.z}}};
    Vec3 normal = (1 / determinant) * (inverse * n);
    return (1 / length(normal)) * normal;
}
