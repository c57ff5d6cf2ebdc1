// Hidden suite of point_at.
#include "exercises/06_geometry/point_at.h"

#include <cmath>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/06_geometry/placed_shapes.h"

using namespace course;

namespace {

void check_point(const Line& line, double t) {
    const auto along = [&](double q, double u) { return std::fma(t, u, q); };
    const std::optional<Vec3> got = point_at(line, t);
    REQUIRE(got.has_value());
    CHECK_THAT(*got, IsAt({along(line.q.x, line.u.x), along(line.q.y, line.u.y),
                           along(line.q.z, line.u.z)},
                          length(line.q) + (1 + std::abs(t)) * length(line.u)));
}

/// Lines in all places, with directions of all lengths.
std::vector<Line> lines(Extent extent) {
    hidden::Chance chance(601);
    std::vector<Line> result;
    for (const hidden::Placement& placement : hidden::placements())
        for (const double size : {1.0, 0.01, 300.0})
            result.push_back({placement.point(chance.point()),
                              size * placement.direction(chance.direction()),
                              extent});
    return result;
}

}  // namespace

TEST_CASE("points all along a line", "[points:2]") {
    hint("Is t counted in lengths of u, or did you change u?");
    for (const Line& line : lines(Extent::line))
        for (const double t : {-1000.0, -1.0, -0.25, 0.0, 0.5, 1.0, 1.5, 70.0})
            check_point(line, t);
}

TEST_CASE("points of a ray, and none before it begins", "[points:2]") {
    hint("Where does a ray begin? Does it end?");
    for (const Line& ray : lines(Extent::ray)) {
        for (const double t : {0.0, 1e-12, 0.3, 1.0, 1.000001, 2.0, 1000.0})
            check_point(ray, t);
        for (const double t : {-1e-12, -0.5, -1.0, -1000.0})
            CHECK_FALSE(point_at(ray, t).has_value());
    }
}

TEST_CASE("points of a segment, and none beyond its ends", "[points:2]") {
    hint("Do both ends belong to it? What about a t just beyond them?");
    for (const Line& segment : lines(Extent::segment)) {
        for (const double t : {0.0, 1e-12, 0.25, 0.5, 0.999999, 1.0})
            check_point(segment, t);
        for (const double t : {-1e-12, -0.5, -1.0, 1.000000001, 1.5, 1000.0})
            CHECK_FALSE(point_at(segment, t).has_value());
    }
}

TEST_CASE("the end of a segment is q + u", "[points:1]") {
    hint("Is u the other end of the segment, or the way there?");
    const Line segment{{3, -4, 5}, {2, 8, -16}, Extent::segment};
    const std::optional<Vec3> begin = point_at(segment, 0);
    REQUIRE(begin.has_value());
    CHECK(*begin == Vec3{3, -4, 5});
    const std::optional<Vec3> end = point_at(segment, 1);
    REQUIRE(end.has_value());
    CHECK(*end == Vec3{5, 4, -11});
    const std::optional<Vec3> middle = point_at(segment, 0.5);
    REQUIRE(middle.has_value());
    CHECK(*middle == Vec3{4, 0, -3});
}
