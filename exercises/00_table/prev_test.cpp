#include "exercises/00_table/prev.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("in a triangle, the half-edge before is two steps ahead",
          "[points:1]") {
    hint("If you follow next for ever, what do you meet just before i?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(::prev(slide.he, 3) == 1);
    CHECK(::prev(slide.he, 8) == 9);
}

TEST_CASE("faces with more sides have a longer way round", "[points:1]") {
    hint("How many steps do you take, and who told you that number?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(::prev(slide.he, 4) == 12);
    CHECK(::prev(slide.he, 11) == 4);
}

TEST_CASE("the half-edge before a border half-edge is on the border",
          "[points:1]") {
    hint("Is a border loop any different from a face, for next?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(::prev(slide.he, 0) == 13);
    CHECK(::prev(slide.he, 7) == 6);
}

TEST_CASE("what comes before the sides of faces, on generated meshes",
          "[points:1]") {
    hint("How many sides may a face have, and does your walk come back?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            const std::vector<int> corners = expected.face_vertices(i);
            for (int side = 0; side < he.size() && !corners.empty(); ++side)
                if (expected.face(side) == expected.face(i) &&
                    expected.start(side) == corners.back())
                    REQUIRE(::prev(he, i) == side);
        });
}
