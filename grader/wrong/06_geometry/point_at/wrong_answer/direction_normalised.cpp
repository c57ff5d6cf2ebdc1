// Makes u a unit vector: then t is another number.
// Hint: You count t in units of length and not in lengths of u.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent != Extent::line && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return line.q + (t / length(line.u)) * line.u;
}
