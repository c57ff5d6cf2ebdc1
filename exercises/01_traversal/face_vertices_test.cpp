#include "exercises/01_traversal/face_vertices.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("the vertices of the faces of the slide mesh, in order",
          "[points:1]") {
    hint("Where does i begin, and where does the half-edge after it begin?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_vertices(slide.he, 1) == std::vector{0, 2, 1});
    CHECK(face_vertices(slide.he, 4) == std::vector{1, 2, 5, 4});
    CHECK(face_vertices(slide.he, 8) == std::vector{5, 2, 3});
}

TEST_CASE("the list begins at the vertex that i leaves", "[points:1]") {
    hint("What changes when you begin at another side of the same face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_vertices(slide.he, 11) == std::vector{2, 5, 4, 1});
    CHECK(face_vertices(slide.he, 12) == std::vector{4, 1, 2, 5});
    CHECK(face_vertices(slide.he, 15) == std::vector{5, 4, 1, 2});
}

TEST_CASE("a half-edge on the border has no face, so no vertices of one",
          "[points:1]") {
    hint("What does fi say on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_vertices(slide.he, 0).empty());
    CHECK(face_vertices(slide.he, 7).empty());
}

TEST_CASE("the vertices of faces, on generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            REQUIRE(face_vertices(he, i) == expected.face_vertices(i));
        });
}
