// Minors instead of cofactors: every second sign is wrong.
// Hint: Some entries of your matrix have the wrong sign.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(a, c), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = (1 / determinant) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
