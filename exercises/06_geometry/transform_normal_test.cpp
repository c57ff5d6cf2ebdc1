#include "exercises/06_geometry/transform_normal.h"

#include "course/runner/geometry.h"
#include "course/runner/suite.h"

using namespace course;

TEST_CASE("a roof that is made twice as wide", "[points:1]") {
    hint("Is the normal orthogonal to the wider roof?");
    const Mat3 wide{{{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
    CHECK_THAT(transform_normal(wide, {1, 1, 0}), IsDirection({1, 2, 0}));
}

TEST_CASE("a shear", "[points:1]") {
    hint("Is it the inverse that you multiply by, or its transpose?");
    const Mat3 shear{{{{1, 1, 0}, {0, 1, 0}, {0, 0, 1}}}};
    CHECK_THAT(transform_normal(shear, {1, 0, 0}), IsDirection({1, -1, 0}));
}

TEST_CASE("a shadow has no inverse", "[points:1]") {
    hint("Which number tells that a matrix has no inverse?");
    const Mat3 shadow{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 0}}}};
    CHECK_THROWS_AS(transform_normal(shadow, {0, 0, 1}), std::domain_error);
}
