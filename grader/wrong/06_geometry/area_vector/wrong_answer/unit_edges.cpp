// Brings the edges to unit length first; two equal corners give NaN.
// Hint: You divide by a length that is 0 where corners coincide.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 u = b - a;
    Vec3 v = c - a;
    return length(u) * length(v) *
           cross((1 / length(u)) * u, (1 / length(v)) * v);
}
