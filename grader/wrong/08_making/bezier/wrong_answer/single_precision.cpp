// Computes in float.
// Hint: Your points are nearly right: somewhere you compute with fewer digits
// than a double has.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double exact) {
    float t = static_cast<float>(exact);
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    std::vector<Vec3> left(points.begin(), points.end());
    while (left.size() > 1) {
        for (std::size_t k = 0; k + 1 < left.size(); ++k)
            left[k] = (1 - t) * left[k] + t * left[k + 1];
        left.pop_back();
    }
    return left[0];
}
