#include "exercises/06_geometry/point_at.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a line has a point for each t", "[points:1]") {
    hint("How far along u is t = 0.5, and where is t = -1?");
    const Line line{{1, 0, 0}, {0, 4, 0}, Extent::line};
    for (const double t : {-1.0, 0.0, 0.5, 1.5}) {
        const std::optional<Vec3> got = point_at(line, t);
        REQUIRE(got.has_value());
        CHECK_THAT(*got, IsAt({1, 4 * t, 0}, 4));
    }
}

TEST_CASE("a ray begins, and a segment ends as well", "[points:1]") {
    hint("Which t are allowed for a ray, and which for a segment?");
    const Line ray{{1, 0, 0}, {0, 4, 0}, Extent::ray};
    CHECK(point_at(ray, 1.5).has_value());
    CHECK_FALSE(point_at(ray, -1).has_value());
    const Line segment{{1, 0, 0}, {0, 4, 0}, Extent::segment};
    CHECK(point_at(segment, 1).has_value());
    CHECK_FALSE(point_at(segment, 1.5).has_value());
    CHECK_FALSE(point_at(segment, -1).has_value());
}
