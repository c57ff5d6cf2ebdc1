// Hidden suite of face_sides.
#include "exercises/01_traversal/face_sides.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("faces of every size, from each of their half-edges", "[points:2]") {
    hint("Does it matter at which side of the face you start?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.face(i) == -1) return;
            if (expected.place_of_face(i) == Place::degenerate) return;
            REQUIRE(face_sides(he, i) == expected.face_sides(i));
        });
}

TEST_CASE("border half-edges of every mesh have no face", "[points:1]") {
    hint("A border loop is walked by next, too. Is its length a face's?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.face(i) == -1) REQUIRE(face_sides(he, i) == 0);
        });
}

TEST_CASE("faces that come to a vertex twice, or share several edges",
          "[points:1]") {
    hint("Your walk ends: because it is at the first half-edge, or at ...?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::degenerate)
                REQUIRE(face_sides(he, i) == expected.face_sides(i));
        });
    const Fixture spur = hidden::spur();
    const OnMesh on(spur);
    CHECK(face_sides(spur.he, hidden::half_edge(spur, 0, 4)) == 6);
    CHECK(face_sides(spur.he, hidden::half_edge(spur, 1, 2)) == 6);
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_sides(he, i) == expected.face_sides(i));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_sides(he, i) == expected.face_sides(i));
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one face?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::has_face,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE(face_sides(he, at.row()) == expected.face_sides(at.i));
        });
}
