#include "exercises/01_traversal/vertex_faces.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("the faces at the vertices of the slide mesh", "[points:2]") {
    hint("Which face does each half-edge that leaves the vertex run along?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(vertex_faces(slide.he, 3), IsRotationOf({0, 1, 2}));
    CHECK_THAT(vertex_faces(slide.he, 4), IsRotationOf({1, 0}));
    CHECK_THAT(vertex_faces(slide.he, 9), IsRotationOf({2}));
}

TEST_CASE("the gap at the border is no face", "[points:1]") {
    hint("The walk passes half-edges on the border. What is their fi?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(vertex_faces(slide.he, 0), IsRotationOf({0, 1, 2}));
    CHECK_THAT(vertex_faces(slide.he, 7), IsRotationOf({1}));

    const Fixture dangling = zoo::dangling();
    const OnMesh on_dangling(dangling);
    CHECK_THAT(vertex_faces(dangling.he, 7), IsRotationOf({1}));
}

TEST_CASE("the faces at vertices, on generated meshes", "[points:1]") {
    hint("A vertex may have faces all round. When has the walk come back?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const oracle::ByFaces& expected) {
        REQUIRE_THAT(vertex_faces(he, i), IsRotationOf(expected.faces_met(i)));
    });
}
