#include "exercises/01_traversal/vertex_degree.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("edges at the vertices of the slide mesh", "[points:2]") {
    hint("Which two steps bring you from one edge of the vertex to the next?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(vertex_degree(slide.he, 3) == 4);
    CHECK(vertex_degree(slide.he, 4) == 3);
    CHECK(vertex_degree(slide.he, 8) == 3);
    CHECK(vertex_degree(slide.he, 9) == 2);
}

TEST_CASE("border and loose edges count, from wherever you start",
          "[points:1]") {
    hint("Is there anything in the walk that needs a face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(vertex_degree(slide.he, 0) == 4);
    CHECK(vertex_degree(slide.he, 7) == 2);

    const Fixture dangling = zoo::dangling();
    const OnMesh on_dangling(dangling);
    CHECK(vertex_degree(dangling.he, 7) == 3);
}

TEST_CASE("the edges at vertices, on generated meshes", "[points:1]") {
    hint(
        "How many edges may meet at a vertex, and how do you know the last "
        "one?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
}
