// Numbers the corners of the polygon that is left, not of the whole.
// Hint: You give the places of the corners in what is left of the polygon, not
// their numbers in the whole one.
#include "exercises/08_making/triangulate.h"

#include <string>

namespace {

/// Above 0 when a, b, c turn to the left, seen from the tip of the normal.
double turn(Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    return dot(cross(b - a, c - a), normal);
}

Vec3 normal_of(std::span<const Vec3> polygon) {
    Vec3 sum;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
        sum = sum + cross(polygon[k] - polygon[0], polygon[k + 1] - polygon[0]);
    return sum;
}

/// Whether p lies in the triangle or on its sides.
bool in_triangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
    return turn(a, b, p, normal) >= 0 && turn(b, c, p, normal) >= 0 &&
           turn(c, a, p, normal) >= 0;
}

/// The corners that are left, and the three of them at place k.
std::array<int, 3> corner_at(const std::vector<int>& left, std::size_t k) {
    std::size_t n = left.size();
    return {static_cast<int>((k + n - 1) % n), static_cast<int>(k),
            static_cast<int>((k + 1) % n)};
}

bool is_ear(std::span<const Vec3> polygon, const std::vector<int>& left,
            std::array<int, 3> corner, Vec3 normal) {
    auto at = [&](int v) { return polygon[static_cast<std::size_t>(v)]; };
    Vec3 a = at(corner[0]), b = at(corner[1]), c = at(corner[2]);
    if (turn(a, b, c, normal) <= 0) return false;
    for (int v : left)
        if (v != corner[0] && v != corner[1] && v != corner[2] &&
            in_triangle(at(v), a, b, c, normal))
            return false;
    return true;
}

}  // namespace

std::vector<std::array<int, 3>> triangulate(std::span<const Vec3> polygon) {
    if (polygon.size() < 3)
        throw std::invalid_argument(
            "a polygon has three corners or more, not " +
            std::to_string(polygon.size()));
    Vec3 normal = normal_of(polygon);
    std::vector<int> left;
    for (std::size_t v = 0; v < polygon.size(); ++v)
        left.push_back(static_cast<int>(v));

    std::vector<std::array<int, 3>> triangles;
    while (left.size() > 3) {
        std::size_t k = 0;
        while (k < left.size() &&
               !is_ear(polygon, left, corner_at(left, k), normal))
            ++k;
        if (k == left.size()) k = 0;
        triangles.push_back(corner_at(left, k));
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(k));
    }
    triangles.push_back({left[0], left[1], left[2]});
    return triangles;
}
