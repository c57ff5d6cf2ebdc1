// As long as the area, not twice.
// Hint: Your vector is as long as the area; the contract has it twice as long.
#include "exercises/06_geometry/area_vector.h"

Vec3 area_vector(Vec3 a, Vec3 b, Vec3 c) {
    return 0.5 * cross(b - a, c - a);
}
