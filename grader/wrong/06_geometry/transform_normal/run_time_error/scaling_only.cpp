// Looks at the diagonal only: a quarter turn seems singular to it.
// Hint: You are right for matrices that stretch along the axes, but not for
// others.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    Vec3 a{m.rows[0].x, 0, 0}, b{0, m.rows[1].y, 0}, c{0, 0, m.rows[2].z};
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = (1 / determinant) * (cofactors * n);
    return (1 / length(normal)) * normal;
}
