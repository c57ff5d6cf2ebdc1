// Lets t be a little outside.
// Hint: You give a point also where t is outside of the extent, be it by a
// little.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t < -1e-9) return std::nullopt;
    if (line.extent == Extent::segment && t > 1 + 1e-6) return std::nullopt;
    return line.q + t * line.u;
}
