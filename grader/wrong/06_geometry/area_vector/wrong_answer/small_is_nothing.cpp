// Takes a small area for none.
// Hint: You take a small triangle for one without an area.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = cross(b - a, c - a);
    return length(n) < 1e-6 ? Vec3{} : n;
}
