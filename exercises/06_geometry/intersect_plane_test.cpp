#include "exercises/06_geometry/intersect_plane.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

const Plane plane{{1, 1, 1}, {0, 0, 2}};

}  // namespace

TEST_CASE("lines through the plane z = 1", "[points:1]") {
    hint("In the equation of the plane, which number is not known?");
    const auto down = intersect_plane({{0, 0, 4}, {0, 0, -8}}, plane);
    REQUIRE(down.has_value());
    CHECK_THAT(*down, IsAbout(0.375));
    const auto slanting = intersect_plane({{2, 5, 4}, {3, -1, 1}}, plane);
    REQUIRE(slanting.has_value());
    CHECK_THAT(*slanting, IsAbout(-3));
}

TEST_CASE("parallel lines, and rays and segments that end before",
          "[points:1]") {
    hint("When is there no t, and when is there one that is not allowed?");
    CHECK_FALSE(intersect_plane({{0, 0, 4}, {1, 0, 0}}, plane).has_value());
    CHECK_FALSE(intersect_plane({{0, 0, 1}, {1, 0, 0}}, plane).has_value());
    const Line up{{0, 0, 4}, {0, 0, 1}, Extent::ray};
    CHECK_FALSE(intersect_plane(up, plane).has_value());
    const Line edge{{0, 0, 4}, {0, 0, -1}, Extent::segment};
    CHECK_FALSE(intersect_plane(edge, plane).has_value());
}
