#include "exercises/00_table/tip.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("half-edges of the slide mesh arrive where the next one leaves",
          "[points:2]") {
    hint("Which vertex is in the row of i, the first or the last of the two?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(tip(slide.he, 4) == 2);
    CHECK(tip(slide.he, 12) == 1);
    CHECK(tip(slide.he, 9) == 5);
}

TEST_CASE("a half-edge on the border arrives at a vertex as well",
          "[points:1]") {
    hint("Which fields does a border half-edge have, and which is -1?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(tip(slide.he, 0) == 0);
    CHECK(tip(slide.he, 10) == 3);
}

TEST_CASE("where the sides of faces arrive, on generated meshes",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            const std::vector<int> corners = expected.face_vertices(i);
            if (!corners.empty()) REQUIRE(tip(he, i) == corners[1]);
        });
}
