// Counts t in units of length.
// Hint: You count t in units of length and not in lengths of u.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double most = length(line.u) * length(plane.u);
    if (std::abs(rate) <= 1e-12 * most) return std::nullopt;

    double t = dot(plane.q - line.q, plane.u) / rate * length(line.u);
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return t;
}
