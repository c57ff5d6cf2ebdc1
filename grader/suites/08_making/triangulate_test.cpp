// Hidden suite of triangulate. Any right cut passes: only properties are asked.
#include "exercises/08_making/triangulate.h"

#include <numbers>
#include <random>

#include "course/runner/suite.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

using Polygon = std::vector<Vec3>;

void check(const Polygon& polygon, const std::string& name) {
    const Fixture drawn = oracle::as_mesh(name, polygon);
    const OnMesh on(drawn);
    REQUIRE_THAT(triangulate(polygon), oracle::CutsUp(polygon));
}

Polygon begun_at(Polygon polygon, std::ptrdiff_t k) {
    std::rotate(polygon.begin(), polygon.begin() + k, polygon.end());
    return polygon;
}

/// From every corner, so that no order of trying is lucky.
void check_all_starts(const Polygon& polygon, const std::string& name) {
    for (std::ptrdiff_t k = 0; k < std::ssize(polygon); ++k)
        check(begun_at(polygon, k), name);
}

Polygon turned_over(Polygon polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
}

/// (x, y, z) becomes (y, z, x): into another plane, with the same turns.
Polygon stood_up(Polygon polygon) {
    for (Vec3& p : polygon) p = {p.y, p.z, p.x};
    return polygon;
}

Polygon regular(int n) {
    Polygon polygon;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.3) / n;
        polygon.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return polygon;
}

// No three corners in line.
Polygon dart() {
    return {{0, 0, 0}, {3, 0, 0}, {1, 1, 0}, {0, 3, 0}};
}
Polygon boot() {  // an L that is a little out of true
    return {{0, 0, 0},   {4, 0.3, 0}, {4.2, 1, 0},
            {1.4, 1, 0}, {1, 3, 0},   {0.1, 3.5, 0}};
}
Polygon two_reflex() {  // the two reflex corners are neighbours
    return {{0, 0, 0},   {5, 0.1, 0},   {5.2, 3, 0},   {4, 2.9, 0},
            {3.9, 1, 0}, {1.1, 1.2, 0}, {1, 2.8, 0.0}, {-0.2, 3.1, 0}};
}
Polygon hook() {  // the only ears are far from the wide parts
    return {{0, 0, 0},     {6, -0.2, 0}, {6.1, 4, 0}, {2, 4.1, 0},
            {1.9, 2.2, 0}, {3, 2, 0},    {3.1, 3, 0}, {5, 3.2, 0},
            {4.9, 1, 0},   {1, 0.9, 0},  {0.9, 5, 0}, {-0.3, 5.1, 0}};
}
Polygon star(int tips) {
    Polygon polygon = regular(2 * tips);
    for (std::size_t k = 0; k < polygon.size(); k += 2)
        polygon[k] = 0.3 * polygon[k];
    return polygon;
}
Polygon spiral(int n) {  // outwards on one side of the strip, and back
    Polygon polygon;
    for (int k = 0; k < 2 * n; ++k) {
        const int step = k < n ? k : 2 * n - 1 - k;
        const double angle = 0.45 * step, r = k < n ? 1 : 0.8;
        const double out = r + 0.08 * step;
        polygon.push_back({out * std::cos(angle), out * std::sin(angle), 0});
    }
    return polygon;
}

// With corners in line, in whole numbers.
Polygon ell() {
    return {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
}
Polygon square_in_eight() {
    return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0},
            {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}};
}
Polygon triangle_in_nine() {
    return {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0},
            {1, 2, 0}, {0, 3, 0}, {0, 2, 0}, {0, 1, 0}};
}
Polygon stairs(int n) {
    Polygon polygon = {{0, 0, 0}};
    for (int k = 0; k < n; ++k) {
        const double x = n - k, y = k;
        polygon.push_back({x, y, 0});
        polygon.push_back({x, y + 1, 0});
    }
    polygon.push_back({0, 1.0 * n, 0});
    return polygon;
}
Polygon comb(int teeth) {
    Polygon polygon = {{0, 0, 0}, {2.0 * teeth - 1, 0, 0}};
    for (int k = teeth - 1; k >= 0; --k) {
        polygon.push_back({2.0 * k + 1, 3, 0});
        polygon.push_back({2.0 * k, 3, 0});
        if (k == 0) break;
        polygon.push_back({2.0 * k, 1, 0});
        polygon.push_back({2.0 * k - 1, 1, 0});
    }
    return polygon;
}
Polygon cross_shape() {
    return {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2, 2, 0},
            {2, 3, 0}, {1, 3, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}, {1, 1, 0}};
}

class Random {
public:
    explicit Random(std::uint64_t salt) : next_(seed() * 1000 + salt) {}
    double between(double a, double b) {
        return a + (b - a) * static_cast<double>(next_() >> 11) / 0x1p53;
    }
    int below(int n) {
        return static_cast<int>(next_() % static_cast<std::uint64_t>(n));
    }

private:
    std::mt19937_64 next_;
};

/// Corners all round the origin, near and far.
Polygon random_star(Random& random) {
    Polygon polygon = regular(5 + random.below(20));
    for (Vec3& p : polygon) p = random.between(0.15, 1) * p;
    return polygon;
}

/// A range of mountains, from the left to the right and back.
Polygon random_range(Random& random) {
    const int n = 3 + random.below(12);
    Polygon polygon;
    for (int k = 0; k < n; ++k)
        polygon.push_back(
            {k + random.between(0, 0.9), random.between(-4, -0.1)});
    for (int k = n - 1; k >= 0; --k)
        polygon.push_back({k + random.between(0, 0.9), random.between(0.1, 4)});
    return polygon;
}

}  // namespace

TEST_CASE("convex polygons", "[points:1]") {
    hint("How many ears has a convex polygon?");
    check_all_starts({{0, 0, 0}, {2, 0, 0}, {1, 1, 0}}, "triangle");
    check_all_starts({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 1, 0}}, "quad");
    for (const int n : {5, 6, 12, 31}) check(regular(n), "regular polygon");
}

TEST_CASE("one reflex corner, wherever the polygon begins", "[points:2]") {
    hint("At which corners does the outline turn to the right?");
    check_all_starts(dart(), "dart");
    check_all_starts(boot(), "boot");
}

TEST_CASE("several reflex corners", "[points:2]") {
    hint("Which corners may lie inside a triangle that you would cut off?");
    check_all_starts(two_reflex(), "two reflex corners");
    check_all_starts(hook(), "hook");
    for (const int tips : {3, 4, 7}) check_all_starts(star(tips), "star");
    check_all_starts(spiral(12), "spiral");
}

TEST_CASE("in any plane, and seen from either side", "[points:2]") {
    hint("Which normal do you use, and does it fit this polygon?");
    for (const Polygon& polygon : {dart(), boot(), two_reflex(), hook()}) {
        check(turned_over(polygon), "seen from behind");
        check(stood_up(polygon), "in the plane y = 0");
        check(stood_up(stood_up(polygon)), "in the plane x = 0");
        check(turned_over(stood_up(polygon)), "in the plane y = 0, behind");
        for (std::ptrdiff_t k = 0; k < 4; ++k)
            check(oracle::moved(begun_at(polygon, k), 1, {}), "in any plane");
        check(turned_over(oracle::moved(polygon, 1, {})), "in any plane");
    }
}

TEST_CASE("corners in line", "[points:2]") {
    hint("May a corner lie on the cut? May an ear have no area?");
    for (const Polygon& polygon : {ell(), square_in_eight(), triangle_in_nine(),
                                   stairs(3), comb(3), cross_shape()}) {
        check_all_starts(polygon, "corners in line");
        check(turned_over(polygon), "corners in line, behind");
        check_all_starts(stood_up(polygon), "corners in line, y = 0");
        check(turned_over(stood_up(stood_up(polygon))), "corners in line");
    }
}

TEST_CASE("random polygons", "[points:2]") {
    hint("Draw this polygon. Which of your triangles is wrong, and why?");
    Random random(1);
    for (int k = 0; k < 60; ++k) {
        Polygon polygon =
            k % 2 == 0 ? random_star(random) : random_range(random);
        if (k % 3 == 0) polygon = turned_over(polygon);
        if (k % 4 > 1) polygon = oracle::moved(polygon, 1, {0.2, -1, 0.4});
        check(begun_at(polygon, random.below(5)), "random polygon");
    }
}

TEST_CASE("tiny, huge, and far from the origin", "[points:1]") {
    hint("Which number in your program is right for one size only?");
    Random random(2);
    for (const double scale : {1e-3, 1.0, 1e4})
        for (const Polygon& polygon :
             {dart(), hook(), star(5), random_star(random)}) {
            check(oracle::moved(polygon, scale, {}), "of another size");
            check(oracle::moved(polygon, scale, scale * Vec3{100, -300, 200}),
                  "far away");
        }
}

TEST_CASE("many corners", "[points:1]") {
    hint("How often do you look at all corners for each triangle?");
    check(spiral(40), "long spiral");
    check(stairs(39), "long stairs");
    check(comb(20), "long comb");
}

TEST_CASE("fewer than three corners are refused", "[points:1]") {
    hint("Which sizes are no polygon?");
    const Polygon two = {{0, 0, 0}, {1, 0, 0}};
    for (const std::size_t n : {std::size_t{0}, std::size_t{1}, two.size()})
        CHECK_THROWS_AS(triangulate(std::span(two).first(n)),
                        std::invalid_argument);
}
