#include "exercises/06_geometry/plane_through.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a horizontal plane, from both sides", "[points:1]") {
    hint("From where are the three points seen counter-clockwise?");
    const auto up = plane_through({1, 0, 5}, {0, 1, 5}, {0, 0, 5});
    REQUIRE(up.has_value());
    CHECK_THAT(up->u, IsDirection({0, 0, 1}));
    CHECK(up->q.z == 5);
    const auto down = plane_through({0, 1, 5}, {1, 0, 5}, {0, 0, 5});
    REQUIRE(down.has_value());
    CHECK_THAT(down->u, IsDirection({0, 0, -1}));
}

TEST_CASE("a plane that cuts off a corner of space", "[points:1]") {
    hint("How long is the normal?");
    const auto got = plane_through({2, 0, 0}, {0, 2, 0}, {0, 0, 2});
    REQUIRE(got.has_value());
    CHECK_THAT(got->u, IsDirection({1, 1, 1}));
}

TEST_CASE("points on a line fix no plane", "[points:1]") {
    hint("How large is the area of the triangle when there is no plane?");
    CHECK_FALSE(plane_through({0, 0, 0}, {1, 1, 1}, {3, 3, 3}).has_value());
    CHECK_FALSE(plane_through({1, 2, 3}, {1, 2, 3}, {0, 0, 1}).has_value());
}
