#include "exercises/01_traversal/face_across.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("edges of the slide mesh between two faces", "[points:2]") {
    hint("Which half-edge runs along the other side of this edge?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_across(slide.he, 3) == 1);
    CHECK(face_across(slide.he, 4) == 0);
    CHECK(face_across(slide.he, 8) == 1);
    CHECK(face_across(slide.he, 11) == 2);
}

TEST_CASE("edges of the slide mesh on the border, from either side",
          "[points:1]") {
    hint("When is there no face across, and how does the function say so?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_across(slide.he, 1) == std::nullopt);
    CHECK(face_across(slide.he, 15) == std::nullopt);
    CHECK(face_across(slide.he, 0) == 0);
    CHECK(face_across(slide.he, 7) == 1);
}

TEST_CASE("the faces across edges, on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            REQUIRE(face_across(he, i) == expected.face_across(i));
        });
}
