// Takes u for a unit vector.
// Hint: You are right only where u has length 1.
#include "exercises/06_geometry/intersect_sphere.h"

#include <cmath>

namespace {

/// The parameters of the whole line.
std::vector<double> on_whole_line(const Line& line, const Sphere& sphere) {
    double nearest = dot(sphere.center - line.q, line.u);
    double r = sphere.radius;
    double d = length(line.q + nearest * line.u - sphere.center);

    if (std::abs(d - r) <= 1e-9 * r) return {nearest};
    if (d > r) return {};
    double half = std::sqrt(r * r - d * d);
    return {nearest - half, nearest + half};
}

bool within(Extent extent, double t) {
    if (extent != Extent::line && t < 0) return false;
    return extent != Extent::segment || t <= 1;
}

}  // namespace

std::vector<double> intersect_sphere(const Line& line, const Sphere& sphere) {
    std::vector<double> parameters;
    for (double t : on_whole_line(line, sphere))
        if (within(line.extent, t)) parameters.push_back(t);
    return parameters;
}
