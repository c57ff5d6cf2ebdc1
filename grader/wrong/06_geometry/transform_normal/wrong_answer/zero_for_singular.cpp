// Returns the zero vector, and does not throw.
// Hint: You do not refuse all matrices that the contract counts as singular.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        return {};

    Vec3 normal = (1 / determinant) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
