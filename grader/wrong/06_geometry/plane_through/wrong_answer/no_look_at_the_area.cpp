// Does not ask whether there is a plane.
// Hint: You give a plane also where the three points do not fix one.
#include "exercises/06_geometry/plane_through.h"

#include <algorithm>

std::optional<Plane> plane_through(Vec3 p, Vec3 q, Vec3 r) {
    Vec3 normal = cross(q - p, r - p);
    double longest = std::max({length(q - p), length(r - q), length(p - r)});
    double twice_area = length(normal);
    return Plane{p, (1 / twice_area) * normal};
}
