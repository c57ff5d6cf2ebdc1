// Leaves out the ends.
// Hint: You leave out an end of a ray or a segment.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t <= 0) return std::nullopt;
    if (line.extent == Extent::segment && t >= 1) return std::nullopt;
    return line.q + t * line.u;
}
