#include "exercises/00_table/edge_vertices.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

using Ends = std::array<int, 2>;

TEST_CASE("edges of the slide mesh have the ends that the table says",
          "[points:2]") {
    hint("Which half-edge of the same edge leaves the other end?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_vertices(slide.he, 12) == Ends{4, 1});
    CHECK(edge_vertices(slide.he, 8) == Ends{5, 2});
    CHECK(edge_vertices(slide.he, 3) == Ends{2, 1});
}

TEST_CASE("a half-edge on the border has two ends as well", "[points:1]") {
    hint(
        "Which field do you read on the way, and does it exist on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_vertices(slide.he, 0) == Ends{2, 0});
    CHECK(edge_vertices(slide.he, 7) == Ends{4, 5});
}

TEST_CASE("the ends of the sides of faces, on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            const std::vector<int> corners = expected.face_vertices(i);
            if (!corners.empty())
                REQUIRE(edge_vertices(he, i) == Ends{corners[0], corners[1]});
        });
}
