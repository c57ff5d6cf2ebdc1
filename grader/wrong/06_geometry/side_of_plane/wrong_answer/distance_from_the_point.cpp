// Asks how far p is from the point of the plane.
// Hint: You put points on one side that are within the tolerance of the plane.
#include "exercises/06_geometry/side_of_plane.h"

#include <cmath>

Side side_of_plane(const Plane& plane, Vec3 p, double tolerance) {
    double distance = dot(p - plane.q, plane.u) / length(plane.u);
    if (length(p - plane.q) <= tolerance) return Side::on;
    return distance > 0 ? Side::positive : Side::negative;
}
