#include "exercises/06_geometry/intersect_plane.h"

std::optional<double> intersect_plane([[maybe_unused]] const Line& line,
                                      [[maybe_unused]] const Plane& plane) {
    // TODO(student): put the point of the line into the equation of the plane.
    return -1e9;
}
