// The edges that meet at b, one of them reversed: the sign is lost.
// Hint: Your vector points to the other side.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    return cross(a - b, c - b);
}
