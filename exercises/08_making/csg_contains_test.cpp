#include "exercises/08_making/csg_contains.h"

#include "course/runner/suite.h"

using namespace course;

namespace {

/// The ball of radius 2 and the box from (0,0,0) to (2,2,2), and an operation.
std::vector<CsgNode> ball_and_box(CsgKind operation) {
    return {{CsgKind::ball, -1, -1, {0, 0, 0}, {2, 0, 0}},
            {CsgKind::box, -1, -1, {0, 0, 0}, {2, 2, 2}},
            {operation, 0, 1, {}, {}}};
}

}  // namespace

TEST_CASE("a ball without one eighth", "[points:1]") {
    hint("When is a point in the difference of a ball and a box?");
    const auto nodes = ball_and_box(CsgKind::difference);
    CHECK(csg_contains(nodes, 2, {-1, 0, 0}));
    CHECK(!csg_contains(nodes, 2, {1, 1, 1}));
    CHECK(!csg_contains(nodes, 2, {-2, -1, 0}));
    CHECK(!csg_contains(nodes, 2, {1.9, 1.9, 1.9}));
}

TEST_CASE("a ball and a box together", "[points:1]") {
    hint("Which of the two contain the point, and what follows?");
    const auto both = ball_and_box(CsgKind::union_of);
    CHECK(csg_contains(both, 2, {-1, 0, 0}));
    CHECK(csg_contains(both, 2, {1, 1, 1}));
    CHECK(csg_contains(both, 2, {1.9, 1.9, 1.9}));
    CHECK(!csg_contains(both, 2, {-2, -1, 0}));
    const auto common = ball_and_box(CsgKind::intersection);
    CHECK(csg_contains(common, 2, {1, 1, 1}));
    CHECK(!csg_contains(common, 2, {-1, 0, 0}));
}
