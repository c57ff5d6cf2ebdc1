// The two edges in the other order: it points to the back.
// Hint: Your vector points to the other side.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    return cross(c - a, b - a);
}
