#include "exercises/06_geometry/area_vector.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the triangles of the statement", "[points:1]") {
    hint("Is the vector as long as twice the area, and on the right side?");
    CHECK_THAT(area_vector({0, 0, 0}, {3, 0, 0}, {0, 4, 0}),
               IsAt({0, 0, 12}, 12));
    CHECK_THAT(area_vector({0, 0, 0}, {0, 4, 0}, {3, 0, 0}),
               IsAt({0, 0, -12}, 12));
    CHECK_THAT(area_vector({1, 2, 3}, {4, 6, 3}, {1, 2, 5}),
               IsAt({8, -6, 0}, 10));
}

TEST_CASE("three points on a line have no area", "[points:1]") {
    hint("Which two edge vectors do you take, and what is their product here?");
    CHECK_THAT(area_vector({0, 0, 0}, {1, 1, 1}, {3, 3, 3}), IsAt({}, 9));
    CHECK_THAT(area_vector({1, 2, 3}, {1, 2, 3}, {4, 5, 7}), IsAt({}, 9));
}
