// Counts small angles as parallel.
// Hint: You take lines for parallel to the plane that meet it at a small
// angle.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double most = length(line.u) * length(plane.u);
    if (std::abs(rate) <= 1e-6 * most) return std::nullopt;

    double t = dot(plane.q - line.q, plane.u) / rate;
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return t;
}
