// Sums Bernstein's polynomials, with factorials that are too large for 64 bits
// from 21 on.
// Hint: With long lists of points the numbers in your formula become too
// large.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    auto factorial = [](std::size_t n) {
        unsigned long long product = 1;
        for (std::size_t k = 2; k <= n; ++k) product *= k;
        return static_cast<double>(product == 0 ? 1 : product);
    };
    std::size_t n = points.size() - 1;
    Vec3 sum;
    for (std::size_t k = 0; k <= n; ++k) {
        double over = factorial(n) / factorial(k) / factorial(n - k);
        double weight = over;
        for (std::size_t i = 0; i < k; ++i) weight *= t;
        for (std::size_t i = k; i < n; ++i) weight *= 1 - t;
        sum = sum + weight * points[k];
    }
    return sum;
}
