// Compares t with the length of the segment.
// Hint: You have another extent for a segment than the contract: look at both
// of its ends.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double most = length(line.u) * length(plane.u);
    if (std::abs(rate) <= 1e-12 * most) return std::nullopt;

    double t = dot(plane.q - line.q, plane.u) / rate;
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > length(line.u)) return std::nullopt;
    return t;
}
