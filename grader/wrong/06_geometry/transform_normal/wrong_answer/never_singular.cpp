// Divides by zero where the matrix is singular.
// Hint: You do not refuse all matrices that the contract counts as singular.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));

    Vec3 normal = (1 / determinant) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
