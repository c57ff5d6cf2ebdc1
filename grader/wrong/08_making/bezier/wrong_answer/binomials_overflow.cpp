// Sums Bernstein's polynomials, with binomials in 32 bits, which overflow from
// 35 points on.
// Hint: With long lists of points the numbers in your formula become too
// large.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    unsigned n = static_cast<unsigned>(points.size()) - 1;
    std::vector<unsigned> over(points.size(), 1);
    for (unsigned row = 1; row <= n; ++row)
        for (unsigned k = row - 1; k > 0; --k) over[k] += over[k - 1];
    Vec3 sum;
    for (unsigned k = 0; k <= n; ++k) {
        double weight = over[k];
        for (unsigned i = 0; i < k; ++i) weight *= t;
        for (unsigned i = k; i < n; ++i) weight *= 1 - t;
        sum = sum + weight * points[k];
    }
    return sum;
}
