// The product by hand, with the sign of y wrong.
// Hint: One coordinate of your vector has the wrong sign.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    Vec3 u = b - a;
    Vec3 v = c - a;
    return {u.y * v.z - u.z * v.y, u.x * v.z - u.z * v.x,
            u.x * v.y - u.y * v.x};
}
