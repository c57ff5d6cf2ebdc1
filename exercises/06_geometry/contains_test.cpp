#include "exercises/06_geometry/contains.h"

#include <vector>

#include "course/runner/suite.h"

using namespace course;

namespace {

const std::vector<Vec2> l_shape{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};

}  // namespace

TEST_CASE("inside and outside of an L", "[points:1]") {
    hint("How often do you cross the border on the way from p to far away?");
    CHECK(contains(l_shape, {0.5, 1.5}));
    CHECK(contains(l_shape, {2, 0.5}));
    CHECK_FALSE(contains(l_shape, {2, 1.5}));
    CHECK_FALSE(contains(l_shape, {-1, 0.5}));
    CHECK_FALSE(contains(l_shape, {4, 0.5}));
    CHECK_FALSE(contains(l_shape, {1, 5}));
}

TEST_CASE("at the height of corners", "[points:1]") {
    hint("Is a corner above p or below it when it is at the same height?");
    CHECK(contains(l_shape, {0.5, 1}));
    CHECK_FALSE(contains(l_shape, {4, 1}));
    CHECK_FALSE(contains(l_shape, {-1, 1}));
    CHECK_FALSE(contains(l_shape, {-1, 0}));
    CHECK_FALSE(contains(l_shape, {-1, 2}));
    const std::vector<Vec2> diamond{{2, 0}, {0, 2}, {-2, 0}, {0, -2}};
    CHECK(contains(diamond, {0, 0}));
    CHECK_FALSE(contains(diamond, {-3, 0}));
    CHECK_FALSE(contains(diamond, {-1, 2}));
}
