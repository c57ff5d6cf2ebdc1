// The mean of the corners, but the normal of the first three.
// Hint: You let the first three corners decide: from another corner on, the
// same polygon has another result.
#include "exercises/06_geometry/planarity_error.h"

#include <algorithm>
#include <string>

std::optional<double> planarity_error(std::span<const Vec3> corners) {
    if (corners.size() < 3)
        throw std::invalid_argument(
            "a polygon has at least three corners, not " +
            std::to_string(corners.size()));

    // All relative to the first corner.
    Vec3 first = corners.front();
    Vec3 before = corners.back();
    Vec3 area, sum;
    double size = 0;
    for (Vec3 p : corners) {
        area = area + area_vector(first, before, p);
        sum = sum + (p - first);
        size += dot(p - before, p - before);
        before = p;
    }
    if (length(area) <= 1e-12 * size) return std::nullopt;
    area = area_vector(corners[0], corners[1], corners[2]);

    Vec3 normal = (1 / length(area)) * area;
    Vec3 mean = (1.0 / static_cast<double>(corners.size())) * sum;
    double farthest = 0;
    for (Vec3 p : corners)
        farthest = std::max(farthest, std::abs(dot(normal, p - first - mean)));
    return farthest;
}
