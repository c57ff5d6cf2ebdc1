// Sums Bernstein's polynomials of degree n instead of n - 1, without the last.
// Hint: Your curve has another degree than its control points give, and does
// not end at the last of them.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    std::size_t n = points.size();
    Vec3 sum;
    double over = 1;
    for (std::size_t k = 0; k < n; ++k) {
        double weight = over;
        for (std::size_t i = 0; i < k; ++i) weight *= t;
        for (std::size_t i = k; i < n; ++i) weight *= 1 - t;
        sum = sum + weight * points[k];
        over = over * static_cast<double>(n - k) / static_cast<double>(k + 1);
    }
    return sum;
}
