// Takes the rows for columns: the inverse, not transposed.
// Hint: You have rows and columns mixed up: right for scalings, but not for
// rotations.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    Vec3 a{m.rows[0].x, m.rows[1].x, m.rows[2].x};
    Vec3 b{m.rows[0].y, m.rows[1].y, m.rows[2].y};
    Vec3 c{m.rows[0].z, m.rows[1].z, m.rows[2].z};
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = (1 / determinant) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
