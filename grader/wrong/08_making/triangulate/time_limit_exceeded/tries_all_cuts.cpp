// Tries every way to cut, and compares areas: the number of ways grows without
// measure.
// Hint: You try so many ways to cut that their number grows beyond measure
// with the corners.
#include "exercises/08_making/triangulate.h"

#include <cmath>

namespace {

using Triangles = std::vector<std::array<int, 3>>;

double area(std::span<const Vec3> p, std::array<int, 3> t) {
    auto at = [&](int v) { return p[static_cast<std::size_t>(v)]; };
    return length(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
}

// The cut with the least area in all is one that does not overlap.
double best(std::span<const Vec3> p, int i, int j, Triangles& cut) {
    cut.clear();
    if (j - i < 2) return 0;
    double least = INFINITY;
    for (int k = i + 1; k < j; ++k) {
        Triangles one, two;
        double sum = area(p, {i, k, j}) + best(p, i, k, one) + best(p, k, j, two);
        if (!(sum < least)) continue;
        least = sum;
        cut = one;
        cut.insert(cut.end(), two.begin(), two.end());
        cut.push_back({i, k, j});
    }
    return least;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon) {
    if (polygon.size() < 3) throw std::invalid_argument("no polygon");
    Triangles cut;
    best(polygon, 0, static_cast<int>(polygon.size()) - 1, cut);
    return cut;
}
