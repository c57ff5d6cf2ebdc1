// Right in exact numbers: the products of the corners lose all digits far away.
// Hint: You lose digits: numbers cancel out that grow with the distance from
// the origin.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    return cross(a, b) + cross(b, c) + cross(c, a);
}
