// The normal, not the area vector.
// Hint: Your vector has the same length for every triangle, large or small.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = cross(b - a, c - a);
    double l = length(n);
    return l > 0 ? (1 / l) * n : n;
}
