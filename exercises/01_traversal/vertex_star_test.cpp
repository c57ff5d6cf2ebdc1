#include "exercises/01_traversal/vertex_star.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("the neighbours of the vertices of the slide mesh", "[points:1]") {
    hint("At which end of an edge is the neighbour, and whose vi is it?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THAT(vertex_star(slide.he, 3), IsRotationOf({1, 5, 3, 0}));
    CHECK_THAT(vertex_star(slide.he, 4), IsRotationOf({2, 0, 4}));
    CHECK_THAT(vertex_star(slide.he, 9), IsRotationOf({5, 2}));
}

TEST_CASE("each half-edge that leaves the vertex is a start, on the border too",
          "[points:1]") {
    hint("Is there anything in the walk that needs a face?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    for (const int i : {0, 3, 11, 14})
        CHECK_THAT(vertex_star(slide.he, i), IsRotationOf({1, 5, 3, 0}));
}

TEST_CASE("a loose edge leads to a neighbour", "[points:1]") {
    hint("Where does the walk go when neither side of an edge has a face?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK_THAT(vertex_star(dangling.he, 7), IsRotationOf({5, 1, 6}));
    CHECK_THAT(vertex_star(dangling.he, 12), IsRotationOf({5, 1, 6}));
}

TEST_CASE("the neighbours of vertices, on generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const oracle::ByFaces& expected) {
        REQUIRE_THAT(vertex_star(he, i), IsRotationOf(expected.vertex_star(i)));
    });
}
