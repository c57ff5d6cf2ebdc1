// Asks whether both ends of a segment are on one side; forgets the ends that are in the plane.
// Hint: You leave out an end where it lies in the plane.
#include "exercises/06_geometry/intersect_plane.h"

#include <cmath>

std::optional<double> intersect_plane(const Line& line, const Plane& plane) {
    double rate = dot(line.u, plane.u);
    double most = length(line.u) * length(plane.u);
    if (std::abs(rate) <= 1e-12 * most) return std::nullopt;

    double t = dot(plane.q - line.q, plane.u) / rate;
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment &&
        dot(line.q - plane.q, plane.u) *
                dot(line.q + line.u - plane.q, plane.u) >=
            0) return std::nullopt;
    return t;
}
