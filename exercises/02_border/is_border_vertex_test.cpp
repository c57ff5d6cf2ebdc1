#include "exercises/02_border/is_border_vertex.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("every vertex of the slide mesh lies on its border", "[points:1]") {
    hint("The half-edge that you are given need not be the one on the border.");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(is_border_vertex(slide.he, 0));   // vertex 2, along the border
    CHECK(is_border_vertex(slide.he, 4));   // vertex 1, along face 1
    CHECK(is_border_vertex(slide.he, 14));  // vertex 2, along face 2
    CHECK(is_border_vertex(slide.he, 15));  // vertex 5, along face 1
}

TEST_CASE("vertex 0 of a fan of six lies inside, the others do not",
          "[points:2]") {
    hint("Once round the vertex: what did you see, and when are you back?");
    const Fixture fan = zoo::fan6();
    const OnMesh on(fan);
    for (int i = 0; i < fan.he.size(); ++i) {
        const int vertex = fan.he.rows()[static_cast<std::size_t>(i)].vi;
        CHECK(is_border_vertex(fan.he, i) == (vertex != 0));
    }
}

TEST_CASE("vertices of generated meshes, inside and on the border",
          "[points:1]") {
    hint("The border may be anywhere round the vertex. When did you stop?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const oracle::ByFaces& expected) {
        const auto edges = static_cast<std::size_t>(expected.vertex_degree(i));
        REQUIRE(is_border_vertex(he, i) ==
                (expected.faces_met(i).size() < edges));
    });
}
