// Gives the origin where there is no point.
// Hint: You give a point also where t is outside of the extent, be it by a
// little.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t < 0) return Vec3{};
    if (line.extent == Extent::segment && t > 1) return Vec3{};
    return line.q + t * line.u;
}
