#include "exercises/01_traversal/adjacent_edge_count.h"

#include "course/runner/suite.h"

using namespace course;

TEST_CASE("sides of the slide mesh's faces with a neighbour", "[points:2]") {
    hint("On each side of the face: what is across?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(adjacent_edge_count(slide.he, 1) == 1);
    CHECK(adjacent_edge_count(slide.he, 4) == 2);
    CHECK(adjacent_edge_count(slide.he, 15) == 2);
    CHECK(adjacent_edge_count(slide.he, 9) == 1);
}

TEST_CASE("a half-edge on the border has no face, so no side to count",
          "[points:1]") {
    hint("Each border half-edge has a face across. Is it on a face itself?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(adjacent_edge_count(slide.he, 0) == 0);
    CHECK(adjacent_edge_count(slide.he, 7) == 0);
}
