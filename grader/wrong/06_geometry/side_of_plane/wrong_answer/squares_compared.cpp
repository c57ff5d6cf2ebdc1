// Compares the square of the distance.
// Hint: You compare with the tolerance something that is not quite the
// distance.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) / length(plane.u);
    if (distance * distance <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
