// Divides by the absolute value of the determinant.
// Hint: You turn the normal to the other side where the matrix mirrors.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = (1 / std::abs(determinant)) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
