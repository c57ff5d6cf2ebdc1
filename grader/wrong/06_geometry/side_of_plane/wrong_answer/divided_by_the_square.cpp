// Divides by the square of the length.
// Hint: Your distance depends on how long the normal is.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) / dot(plane.u, plane.u);
    if (std::abs(distance) <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
