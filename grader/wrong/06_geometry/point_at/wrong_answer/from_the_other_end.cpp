// Mixes up the ends: t = 0 is q + u.
// Hint: You begin at the wrong end of the segment.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return line.q + (1 - t) * line.u;
}
