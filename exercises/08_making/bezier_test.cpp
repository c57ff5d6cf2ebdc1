#include "exercises/08_making/bezier.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("three points, half way", "[points:1]") {
    hint("Which two points are left after the first step, and which one then?");
    const std::vector<Vec3> points = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}};
    CHECK_THAT(bezier(points, 0.5), IsAt({1.5, 0.5, 0}, 1));
}

TEST_CASE("the curve joins the first point to the last", "[points:1]") {
    hint("Where does each segment get divided for t = 0, and for t = 1?");
    const std::vector<Vec3> points = {
        {1, 2, 3}, {5, 1, 0}, {-3, 2, 1}, {4, 4, 4}};
    CHECK_THAT(bezier(points, 0), IsAt({1, 2, 3}, 1));
    CHECK_THAT(bezier(points, 1), IsAt({4, 4, 4}, 1));
}

TEST_CASE("no control points are refused", "[points:1]") {
    hint("What could be returned when there is no point at all?");
    CHECK_THROWS_AS(bezier({}, 0.5), std::invalid_argument);
}
