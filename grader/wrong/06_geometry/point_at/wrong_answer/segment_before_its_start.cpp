// Asks about t < 0 for a ray only.
// Hint: You have another extent for a segment than the contract: look at both
// of its ends.
#include "exercises/06_geometry/point_at.h"

std::optional<Vec3> point_at(const Line& line, double t) {
    if (line.extent == Extent::ray && t < 0) return std::nullopt;
    if (line.extent == Extent::segment && t > 1) return std::nullopt;
    return line.q + t * line.u;
}
