// Sees only the shadow on the plane z = 0.
// Hint: Your vector is right only for triangles that lie flat, in a plane of
// one z.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 u = b - a;
    Vec3 v = c - a;
    return {0, 0, u.x * v.y - u.y * v.x};
}
