// Takes the tolerance relative to the distance from the point of the plane.
// Hint: You let the distance from the plane's point decide what counts as on
// the plane.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) / length(plane.u);
    if (std::abs(distance) <= tolerance * length(p - plane.q)) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
