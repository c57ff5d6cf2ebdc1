// Forgets the absolute value: all that is below is on the plane.
// Hint: You get points on the negative side wrong: look at the sign of your
// distance there.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) / length(plane.u);
    if (distance <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
