// Treats rays and segments as lines.
// Hint: You give a point also where t is outside of the extent, be it by a
// little.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double most = length(line.u) * length(plane.u);
    if (std::abs(rate) <= 1e-12 * most) return std::nullopt;

    double t = dot(plane.q - line.q, plane.u) / rate;
    return t;
}
