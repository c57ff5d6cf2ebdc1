// Weighs the points with t^k (1-t)^(n-k) and forgets the binomials.
// Hint: Your curve has the right ends, and takes another way between them.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    Vec3 sum;
    for (std::size_t k = 0; k < points.size(); ++k) {
        double weight = 1;
        for (std::size_t i = 0; i < k; ++i) weight *= t;
        for (std::size_t i = k + 1; i < points.size(); ++i) weight *= 1 - t;
        sum = sum + weight * points[k];
    }
    return sum;
}
