// Brings the edges to unit length first; two equal corners give NaN.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 u = b - a;
    Vec3 v = c - a;
    return length(u) * length(v) *
           cross((1 / length(u)) * u, (1 / length(v)) * v);
}
