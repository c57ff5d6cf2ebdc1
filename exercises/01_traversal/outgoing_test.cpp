#include "exercises/01_traversal/outgoing.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("the half-edges that leave the vertices of the slide mesh",
          "[points:2]") {
    hint("Which half-edge do you begin with, and who tells you?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    const Anchors anchors{{1, 4, 3, 9, 7, 8}, {1, 4, 8}};
    CHECK_THAT(outgoing(slide.he, anchors, 0), IsRotationOf({1, 2}));
    CHECK_THAT(outgoing(slide.he, anchors, 1), IsRotationOf({4, 5, 6}));
    CHECK_THAT(outgoing(slide.he, anchors, 2), IsRotationOf({3, 11, 14, 0}));
    CHECK_THAT(outgoing(slide.he, anchors, 3), IsRotationOf({9, 13}));

    const Anchors others{{2, 6, 14, 13, 12, 15}, {5, 15, 9}};
    CHECK_THAT(outgoing(slide.he, others, 2), IsRotationOf({3, 11, 14, 0}));
    CHECK_THAT(outgoing(slide.he, others, 5), IsRotationOf({8, 15, 10}));
}

TEST_CASE("nothing leaves an isolated vertex", "[points:1]") {
    hint("What does the anchor -1 say?");
    Fixture slide = zoo::slide();
    slide.mesh.positions.push_back({3, 2});
    const OnMesh on(slide);
    const Anchors anchors{{1, 4, 3, 9, 7, 8, -1}, {1, 4, 8}};
    CHECK(outgoing(slide.he, anchors, 6).empty());
    CHECK_THAT(outgoing(slide.he, anchors, 4), IsRotationOf({7, 12}));
}
