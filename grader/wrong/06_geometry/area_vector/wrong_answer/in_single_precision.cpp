// Computes in float.
// Hint: You lose digits: a number of yours is not kept in double precision.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    float ux = static_cast<float>(b.x - a.x);
    float uy = static_cast<float>(b.y - a.y);
    float uz = static_cast<float>(b.z - a.z);
    float vx = static_cast<float>(c.x - a.x);
    float vy = static_cast<float>(c.y - a.y);
    float vz = static_cast<float>(c.z - a.z);
    return {uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx};
}
