// Takes every plane for one through the origin.
// Hint: You take every plane for one through the origin.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p, plane.u) / length(plane.u);
    if (std::abs(distance) <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
