#include "exercises/02_border/edge_kind.h"

#include "course/runner/for_each_half_edge.h"

using namespace course;

TEST_CASE("edge 1-2 of the slide mesh lies between two faces", "[points:1]") {
    hint("Which face is on this side of the edge, and which on the other?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_kind(slide.he, 3) == EdgeKind::interior);
    CHECK(edge_kind(slide.he, 4) == EdgeKind::interior);
}

TEST_CASE("edge 0-2 of the slide mesh has one face", "[points:1]") {
    hint("One of its two half-edges has a face. Which one were you given?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK(edge_kind(slide.he, 0) == EdgeKind::border);
    CHECK(edge_kind(slide.he, 1) == EdgeKind::border);
}

TEST_CASE("edge 4-6 hangs on the slide mesh without a face", "[points:1]") {
    hint("How do the two sides of a loose edge differ from those of a border?");
    const Fixture dangling = zoo::dangling();
    const OnMesh on(dangling);
    CHECK(edge_kind(dangling.he, 16) == EdgeKind::dangling);
    CHECK(edge_kind(dangling.he, 17) == EdgeKind::dangling);
    CHECK(edge_kind(dangling.he, 6) == EdgeKind::border);
    CHECK(edge_kind(dangling.he, 12) == EdgeKind::border);
}

TEST_CASE("kinds of edges, on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const oracle::ByFaces& expected) {
            const bool here = expected.face(i) != -1;
            const bool there = expected.face_across(i).has_value();
            REQUIRE(edge_kind(he, i) ==
                    (here && there ? EdgeKind::interior : EdgeKind::border));
        });
}
