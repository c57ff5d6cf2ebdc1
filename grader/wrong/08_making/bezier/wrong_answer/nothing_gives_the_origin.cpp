// Returns the origin when there are no points.
// Hint: You give a point where the contract refuses.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty()) return {};
    std::vector<Vec3> left(points.begin(), points.end());
    while (left.size() > 1) {
        for (std::size_t k = 0; k + 1 < left.size(); ++k)
            left[k] = (1 - t) * left[k] + t * left[k + 1];
        left.pop_back();
    }
    return left[0];
}
