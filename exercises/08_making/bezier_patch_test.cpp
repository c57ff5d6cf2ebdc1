#include "exercises/08_making/bezier_patch.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a patch of four points", "[points:1]") {
    hint("What is the point at u of the lower row, and of the upper row?");
    const ControlGrid grid{2, 2, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {2, 2, 4}}};
    CHECK_THAT(bezier_patch(grid, 0.5, 0.25), IsAt({1, 0.5, 0.5}, 1));
}

TEST_CASE("the corners of three rows of two points", "[points:1]") {
    hint("Which points of the list are the corners of the grid?");
    const ControlGrid grid{
        2,
        3,
        {{0, 0, 1}, {1, 0, 2}, {0, 1, 3}, {1, 1, 4}, {0, 2, 5}, {1, 2, 6}}};
    CHECK_THAT(bezier_patch(grid, 1, 0), IsAt({1, 0, 2}, 1));
    CHECK_THAT(bezier_patch(grid, 0, 1), IsAt({0, 2, 5}, 1));
}

TEST_CASE("a grid that lacks a point is refused", "[points:1]") {
    hint("How many points must there be?");
    CHECK_THROWS_AS(
        bezier_patch({2, 2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, 0, 0),
        std::invalid_argument);
}
