#include "exercises/06_geometry/side_of_plane.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("above and below a horizontal plane", "[points:1]") {
    hint("Which way leads from the plane to the point?");
    const Plane plane{{0, 0, 1}, {0, 0, 1}};
    CHECK(side_of_plane(plane, {5, 5, 3}, 0.01) == Side::positive);
    CHECK(side_of_plane(plane, {5, 5, 0}, 0.01) == Side::negative);
    CHECK(side_of_plane(plane, {5, -5, 1}, 0.01) == Side::on);
    CHECK(side_of_plane({{0, 0, 1}, {0, 0, -1}}, {5, 5, 3}, 0.01) ==
          Side::negative);
}

TEST_CASE("the length of the normal says nothing", "[points:1]") {
    hint("What is the distance of (5, 5, 1.005) from the plane z = 1?");
    const Plane plane{{0, 0, 1}, {0, 0, 10}};
    CHECK(side_of_plane(plane, {5, 5, 1.005}, 0.01) == Side::on);
    CHECK(side_of_plane(plane, {5, 5, 0.995}, 0.01) == Side::on);
    CHECK(side_of_plane(plane, {5, 5, 1.02}, 0.01) == Side::positive);
}
