#include "exercises/01_traversal/face_sides.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("the faces of the slide mesh have 3, 4 and 3 sides", "[points:2]") {
    hint("What do you count, and when have you counted every side once?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_sides(slide.he, 1) == 3);
    CHECK(face_sides(slide.he, 4) == 4);
    CHECK(face_sides(slide.he, 8) == 3);
}

TEST_CASE("a half-edge on the border has no face to count", "[points:1]") {
    hint("What does fi say on the border?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(face_sides(slide.he, 0) == 0);
    CHECK(face_sides(slide.he, 7) == 0);
}

TEST_CASE("the sides of faces, on generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            REQUIRE(face_sides(he, i) == expected.face_sides(i));
        });
}
