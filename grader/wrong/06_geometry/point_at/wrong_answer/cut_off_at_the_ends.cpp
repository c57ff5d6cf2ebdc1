// Takes the nearest end for what is outside.
// Hint: You give a point also where t is outside of the extent, be it by a
// little.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t < 0) return line.q;
    if (line.extent == Extent::segment && t > 1) return line.q + line.u;
    return line.q + t * line.u;
}
