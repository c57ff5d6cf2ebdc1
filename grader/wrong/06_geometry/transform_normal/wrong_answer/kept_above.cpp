// Turns the result to the side on which n was, also where the map turns it
// over.
// Hint: You keep the normal on the side where it was before; a matrix may turn
// it over.
#include "exercises/06_geometry/transform_normal.h"

Vec3 transform_normal(const Mat3& m, Vec3 n) {
    const auto& [a, b, c] = m.rows;
    Mat3 cofactors{{cross(b, c), cross(c, a), cross(a, b)}};
    double determinant = dot(a, cross(b, c));
    if (std::abs(determinant) <= 1e-12 * length(a) * length(b) * length(c))
        throw std::domain_error("the matrix is singular: its determinant is 0");

    Vec3 normal = (1 / determinant) * (cofactors * n);
    if (dot(normal, n) < 0) normal = -1 * normal;
    return (1 / length(normal)) * normal;
}
