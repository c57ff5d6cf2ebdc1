#include "exercises/01_traversal/adjacent_edge_count.h"

#include "course/runner/for_each_half_edge.h"

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

TEST_CASE("sides with a neighbour, on generated meshes", "[points:1]") {
    hint("How many sides may a face have, and how many of them a neighbour?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const oracle::ByFaces& expected) {
        REQUIRE(adjacent_edge_count(he, i) == expected.adjacent_edge_count(i));
    });
}
