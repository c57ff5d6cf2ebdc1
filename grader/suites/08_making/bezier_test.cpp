// Hidden suite of bezier.
#include "exercises/08_making/bezier.h"

#include <cmath>
#include <random>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/08_making/bezier_sums.h"
#include "grader/suites/08_making/making_checks.h"

using namespace course;

namespace {

using Points = std::vector<Vec3>;

const std::vector<double> parameters = {0,    0.1, 0.25, 1.0 / 3, 0.5,
                                        0.62, 0.8, 0.97, 1};

Points random_points(int n, std::uint64_t salt) {
    std::mt19937_64 next(seed() * 1000 + salt);
    const auto number = [&] {
        return static_cast<double>(next() >> 11) / 0x1p52 - 1;
    };
    Points points;
    for (int k = 0; k < n; ++k) {
        const double x = number(), y = number(), z = number();
        points.push_back({x, y, z});
    }
    return points;
}

/// Compares with the sum of Bernstein's polynomials; for points of about 1.
void check(const Points& points) {
    for (const double t : parameters) {
        INFO("t " << t);
        REQUIRE_THAT(bezier(points, t), IsAt(oracle::bezier_sum(points, t), 1));
    }
}

}  // namespace

TEST_CASE("two points are a segment", "[points:1]") {
    hint("Which point divides a segment at t?");
    const Points segment = {{1, -2, 0.5}, {3, 2, -1.5}};
    for (const double t : parameters)
        CHECK_THAT(bezier(segment, t),
                   IsAt({1 + 2 * t, 4 * t - 2, 0.5 - 2 * t}, 1));
}

TEST_CASE("three points are a parabola", "[points:2]") {
    hint("How often must the pairs of neighbours be divided?");
    const Points parabola = {{-1, 1, 0}, {0, -1, 2}, {1, 1, 0}};
    for (const double t : parameters) {
        const double x = 2 * t - 1;
        CHECK_THAT(bezier(parabola, t), IsAt({x, x * x, 1 - x * x}, 1));
    }
    check(random_points(3, 1));
}

TEST_CASE("four points, and more", "[points:2]") {
    hint("Does each step use the points of the step before, and no others?");
    const Points cubic = {{0, 0, 0}, {0, 3, 0}, {3, 3, 0}, {3, 0, 0}};
    CHECK_THAT(bezier(cubic, 0.5), IsAt({1.5, 2.25, 0}, 1));
    CHECK_THAT(bezier(cubic, 1.0 / 3), IsAt({7.0 / 9, 2, 0}, 1));
    for (int n = 4; n < 13; ++n) {
        check(random_points(n, static_cast<std::uint64_t>(n)));
        check(random_points(n, static_cast<std::uint64_t>(n + 20)));
    }
}

TEST_CASE("the ends, whatever is between", "[points:1]") {
    hint("What is (1 - t) a + t b for t = 0 and for t = 1?");
    for (const int n : {2, 3, 5, 8, 21}) {
        const Points points = random_points(n, static_cast<std::uint64_t>(n));
        CHECK_THAT(bezier(points, 0), IsAt(points.front(), 1));
        CHECK_THAT(bezier(points, 1), IsAt(points.back(), 1));
    }
    const Points closed = {{1, 1, 1}, {2, 0, 0}, {0, 5, 0}, {1, 1, 1}};
    CHECK_THAT(bezier(closed, 0), IsAt({1, 1, 1}, 1));
    CHECK_THAT(bezier(closed, 1), IsAt({1, 1, 1}, 1));
}

TEST_CASE("backwards, and with the points moved", "[points:1]") {
    hint("What becomes of the curve when all control points are turned?");
    for (const int n : {3, 4, 6}) {
        const Points points =
            random_points(n, static_cast<std::uint64_t>(n + 40));
        const Points back(points.rbegin(), points.rend());
        for (const double scale : {1e-3, 1.0, 1e4}) {
            const Vec3 by = scale * Vec3{3, -2, 5};
            const Points moved = oracle::moved(points, scale, by);
            for (const double t : parameters) {
                const Points here = {oracle::bezier_sum(points, t)};
                const Vec3 wanted = oracle::moved(here, scale, by)[0];
                CHECK_THAT(bezier(moved, t), IsAt(wanted, scale));
                CHECK_THAT(bezier(back, 1 - t), IsAt(here[0], 1));
            }
        }
    }
}

TEST_CASE("one point, and points in one place", "[points:1]") {
    hint("How many steps are needed for a single control point?");
    for (const double t : parameters) {
        CHECK_THAT(bezier(Points{{3, 1, 2}}, t), IsAt({3, 1, 2}, 1));
        CHECK_THAT(bezier(Points(7, {3, 1, 2}), t), IsAt({3, 1, 2}, 1));
        CHECK_THAT(bezier(Points{{0, 0, 0}, {0, 0, 0}, {1, 2, 3}}, t),
                   IsAt(t * t * Vec3{1, 2, 3}, 1));
    }
}

TEST_CASE("no points are refused at any t", "[points:1]") {
    hint("Is the question asked before a point is read?");
    for (const double t : parameters)
        CHECK_THROWS_AS(bezier(Points{}, t), std::invalid_argument);
}

TEST_CASE("many control points", "[points:1]") {
    hint("Which numbers grow in your program, and which question comes twice?");
    for (const int n : {15, 24, 36, 70, 100})
        check(random_points(n, static_cast<std::uint64_t>(n + 60)));
}
