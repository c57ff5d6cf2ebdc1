// Gets the cosine of an angle, not a distance.
// Hint: You let the distance from the plane's point decide what counts as on
// the plane.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) /
                      (length(plane.u) * length(p - plane.q));
    if (std::abs(distance) <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
