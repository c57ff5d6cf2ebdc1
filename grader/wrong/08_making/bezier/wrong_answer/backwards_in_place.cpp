// Overwrites the points from the end, so that new ones are used for old ones.
// Hint: Your curve has the right ends, and takes another way between them.
#include "exercises/08_making/bezier.h"

#include <vector>

Vec3 bezier(std::span<const Vec3> points, double t) {
    if (points.empty())
        throw std::invalid_argument("a curve has one control point at least");
    std::vector<Vec3> left(points.begin(), points.end());
    while (left.size() > 1) {
        for (std::size_t k = left.size() - 1; k-- > 0;)
            left[k] = (1 - t) * left[k] + t * left[k + 1];
        left.pop_back();
    }
    return left[0];
}
