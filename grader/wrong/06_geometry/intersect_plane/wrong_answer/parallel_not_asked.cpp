// Divides by what may be 0.
// Hint: You find a point also where the line is parallel to the plane, up to
// rounding.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double t = dot(plane.q - line.q, plane.u) / rate;
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return t;
}
