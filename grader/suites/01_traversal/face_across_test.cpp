// Hidden suite of face_across.
#include "exercises/01_traversal/face_across.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("edges between two faces, from both sides", "[points:2]") {
    hint("Whose face are you looking at: that of i or that of its opposite?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_edge(i) == Place::interior)
                REQUIRE(face_across(he, i) == expected.face_across(i));
        });
}

TEST_CASE("edges with a face on one side only, from both sides", "[points:1]") {
    hint("Which side has no face: the one that you are on or the other?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_edge(i) == Place::border)
                REQUIRE(face_across(he, i) == expected.face_across(i));
        });
}

TEST_CASE("edges without a face, and with the same one on both sides",
          "[points:1]") {
    hint("What does the other side say, whatever this side says?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_edge(i) == Place::degenerate)
                REQUIRE(face_across(he, i) == expected.face_across(i));
        });
    const Fixture spur = hidden::spur();
    const OnMesh on(spur);
    CHECK(face_across(spur.he, hidden::half_edge(spur, 0, 4)) == 0);
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_across(he, i) == expected.face_across(i));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_across(he, i) == expected.face_across(i));
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges does an edge have?");
    hidden::for_some_of_a_million(
        many_calls, 64, hidden::anywhere,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            std::optional<int> across = expected.face_across(at.i);
            if (across) across = at.mesh->faces(*across, at.copy);
            REQUIRE(face_across(he, at.row()) == across);
        });
}
