// Has room for sixteen points.
// Hint: You have no room for a long list of points.
#include "exercises/08_making/bezier.h"

#include <array>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    std::array<Vec3, 16> left;
    for (std::size_t k = 0; k < points.size(); ++k) left[k] = points[k];
    for (std::size_t n = points.size() - 1; n > 0; --n) {
        for (std::size_t k = 0; k < n; ++k)
            left[k] = (1 - t) * left[k] + t * left[k + 1];
    }
    return left[0];
}
