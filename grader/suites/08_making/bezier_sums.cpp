#include "grader/suites/08_making/bezier_sums.h"

#include <cmath>

namespace course::oracle {

std::vector<double> bernstein_weights(int n, double t) {
    std::vector<double> weights;
    long double over = 1;  // n - 1 over k
    for (int k = 0; k < n; ++k) {
        const long double weight =
            over * std::pow(static_cast<long double>(t), k) *
            std::pow(1 - static_cast<long double>(t), n - 1 - k);
        weights.push_back(static_cast<double>(weight));
        over = over * (n - 1 - k) / (k + 1);
    }
    return weights;
}

Vec3 bezier_sum(std::span<const Vec3> points, double t) {
    const auto weights = bernstein_weights(static_cast<int>(points.size()), t);
    Vec3 sum;
    for (std::size_t k = 0; k < points.size(); ++k)
        sum = sum + weights[k] * points[k];
    return sum;
}

Vec3 bezier_patch_sum(const ControlGrid& grid, double u, double v) {
    const auto across = bernstein_weights(grid.nu, u);
    const auto up = bernstein_weights(grid.nv, v);
    Vec3 sum;
    std::size_t at = 0;
    for (const double b : up)
        for (const double a : across) sum = sum + a * b * grid.points[at++];
    return sum;
}

}  // namespace course::oracle
