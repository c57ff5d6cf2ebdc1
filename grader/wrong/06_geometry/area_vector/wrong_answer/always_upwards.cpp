// Turns the vector so that z is not negative.
// Hint: You turn vectors that point down.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 n = cross(b - a, c - a);
    return n.z < 0 ? -1 * n : n;
}
