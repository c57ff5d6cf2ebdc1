#include "exercises/06_geometry/signed_area.h"

#include <vector>

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a triangle and a square, in both directions", "[points:1]") {
    hint("Which way round is positive?");
    using Polygon = std::vector<Vec2>;
    CHECK_THAT(signed_area(Polygon{{0, 0}, {4, 0}, {4, 3}}), IsAbout(6));
    CHECK_THAT(signed_area(Polygon{{0, 0}, {4, 3}, {4, 0}}), IsAbout(-6));
    CHECK_THAT(signed_area(Polygon{{1, 1}, {3, 1}, {3, 3}, {1, 3}}),
               IsAbout(4));
}

TEST_CASE("an L is not convex", "[points:1]") {
    hint("What becomes of the triangles that stick out of the polygon?");
    const std::vector<Vec2> polygon{{0, 0}, {3, 0}, {3, 1},
                                    {1, 1}, {1, 2}, {0, 2}};
    CHECK_THAT(signed_area(polygon), IsAbout(4));
}
