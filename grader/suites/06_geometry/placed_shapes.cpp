// Shapes in many places.
#include "grader/suites/06_geometry/placed_shapes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "course/runner/suite.h"

namespace course::hidden {

namespace {

constexpr double pi = 3.14159265358979323846;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

Vec3 unit(Vec3 u) {
    return (1 / length(u)) * u;
}

Placement turned(double scale, Vec3 shift, Chance& chance) {
    const Vec3 x = chance.direction();
    const Vec3 y = across(x, chance);
    return {x, y, cross(x, y), scale, shift};
}

/// The corners where one side of the columns goes from x = 0 to the right.
Polygon steps(const std::vector<int>& heights) {
    Polygon corners;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const double y = heights[k];
        const double x = static_cast<double>(k);
        if (k == 0 || heights[k] != heights[k - 1]) {
            if (k > 0) corners.push_back({x, corners.back().y});
            corners.push_back({x, y});
        }
    }
    corners.push_back({static_cast<double>(heights.size()), corners.back().y});
    return corners;
}

/// Where p lies in its sector of the star: its distance from the origin along
/// its ray, by that of the border.
double relative_radius(const Star& star, Vec2 p, double& from_corner) {
    double angle = std::atan2(p.y, p.x);
    while (angle < star.angles.front()) angle += 2 * pi;
    const std::size_t n = star.angles.size();
    std::size_t k = n - 1;
    while (star.angles[k] > angle) --k;
    const std::size_t next = (k + 1) % n;
    const double end = star.angles[next] + (next == 0 ? 2 * pi : 0);
    from_corner = std::min(angle - star.angles[k], end - angle);
    const Polygon corners = star.polygon();
    const Vec2 a = corners[k];
    const Vec2 d = corners[next] - a;
    return (p.x * d.y - p.y * d.x) / (a.x * d.y - a.y * d.x);
}

}  // namespace

std::vector<Placement> placements() {
    Chance chance(600);
    const Vec3 x{1, 0, 0};
    const Vec3 y{0, 1, 0};
    const Vec3 z{0, 0, 1};
    return {{x, y, z, 1, {}},
            {x, y, z, 1, {100, -20, 3}},
            {y, z, x, 1, {}},
            {y, x, {0, 0, -1}, 8, {4, 0, -8}},
            {x, y, z, 1e-3, {}},
            {x, y, z, 1e4, {}},
            turned(1, {}, chance),
            turned(1, {-7, 11, 13}, chance),
            turned(1e-3, {0.01, 0.02, -0.05}, chance),
            turned(1e4, {3e4, -1e5, 2e4}, chance)};
}

Chance::Chance(std::uint64_t salt) : random_(seed() * 1000 + salt) {}

double Chance::between(double least, double most) {
    const double part = static_cast<double>(random_() >> 11) * 0x1p-53;
    return least + part * (most - least);
}

Vec3 Chance::direction() {
    const double z = between(-1, 1);
    const double angle = between(0, 2 * pi);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

Vec3 Chance::point() {
    const double x = between(-2, 2);
    const double y = between(-2, 2);
    return {x, y, between(-2, 2)};
}

int Chance::below(int n) {
    return static_cast<int>(random_() % static_cast<std::uint64_t>(n));
}

Vec3 across(Vec3 u, Chance& chance) {
    const Vec3 e =
        std::abs(u.x) < 0.6 * length(u) ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 a = unit(cross(u, e));
    const Vec3 b = unit(cross(u, a));
    const double angle = chance.between(0, 2 * pi);
    return unit(std::cos(angle) * a + std::sin(angle) * b);
}

Polygon reversed(Polygon polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

Polygon begun_at(Polygon polygon, int k) {
    std::rotate(polygon.begin(), polygon.begin() + k, polygon.end());
    return polygon;
}

Polygon Star::polygon() const {
    Polygon corners;
    for (std::size_t k = 0; k < angles.size(); ++k)
        corners.push_back(radii[k] *
                          Vec2{std::cos(angles[k]), std::sin(angles[k])});
    return corners;
}

double Star::area() const {
    double sum = 0;
    for (std::size_t k = 0; k < angles.size(); ++k) {
        const std::size_t next = (k + 1) % angles.size();
        sum += radii[k] * radii[next] * std::sin(angles[next] - angles[k]) / 2;
    }
    return sum;
}

bool Star::clear_of_border(Vec2 p, double margin) const {
    double from_corner = 0;
    const double r = relative_radius(*this, p, from_corner);
    return std::abs(r - 1) > margin && from_corner > margin;
}

bool Star::inside(Vec2 p) const {
    double from_corner = 0;
    return relative_radius(*this, p, from_corner) < 1;
}

Star star(int corners, Chance& chance) {
    Star result;
    for (int k = 0; k < corners; ++k) {
        result.angles.push_back((k + chance.between(0, 0.8)) * 2 * pi /
                                corners);
        result.radii.push_back(chance.between(0.4, 2));
    }
    return result;
}

Polygon Columns::polygon() const {
    Polygon corners = steps(low);
    const Polygon above = reversed(steps(high));
    corners.insert(corners.end(), above.begin(), above.end());
    return corners;
}

double Columns::area() const {
    double sum = 0;
    for (std::size_t k = 0; k < low.size(); ++k) sum += high[k] - low[k];
    return sum;
}

bool Columns::inside(Vec2 p) const {
    const double column = std::floor(p.x);
    const auto among = [&](double k) {
        if (k < 0 || k >= static_cast<double>(low.size())) return false;
        const std::size_t i = at(static_cast<int>(k));
        return low[i] < p.y && p.y < high[i];
    };
    return among(column) && (column != p.x || among(column - 1));
}

bool Columns::on_border(Vec2 p) const {
    for (std::size_t k = 0; k < low.size(); ++k) {
        const double x = static_cast<double>(k);
        const bool in_x = x <= p.x && p.x <= x + 1;
        if (in_x && (p.y == low[k] || p.y == high[k])) return true;
    }
    if (p.x != std::floor(p.x)) return false;
    const bool left = Columns{low, high}.inside({p.x - 0.5, p.y});
    const bool right = Columns{low, high}.inside({p.x + 0.5, p.y});
    return left != right;
}

Columns columns(int n, Chance& chance) {
    Columns result;
    for (int k = 0; k < n; ++k) {
        // All have y from -1 to 1 in common.
        result.low.push_back(-1 - chance.below(4));
        result.high.push_back(1 + chance.below(4));
    }
    return result;
}

}  // namespace course::hidden
