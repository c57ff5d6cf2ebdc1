// Hidden suite of face_vertices.
#include "exercises/01_traversal/face_vertices.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("faces of every size, begun at each of their vertices",
          "[points:2]") {
    hint("Which vertex must come first, and which one next?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.face(i) == -1) return;
            if (expected.place_of_face(i) == Place::degenerate) return;
            REQUIRE(face_vertices(he, i) == expected.face_vertices(i));
        });
}

TEST_CASE("border half-edges of every mesh have no face", "[points:1]") {
    hint("A border loop has vertices, too. Are they those of a face?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.face(i) == -1) REQUIRE(face_vertices(he, i).empty());
        });
}

TEST_CASE("faces that come to a vertex twice, or share several edges",
          "[points:1]") {
    hint(
        "Your walk ends: because of the half-edge that it is at, or the "
        "vertex?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::degenerate)
                REQUIRE(face_vertices(he, i) == expected.face_vertices(i));
        });
    const Fixture spur = hidden::spur();
    const OnMesh on(spur);
    CHECK(face_vertices(spur.he, hidden::half_edge(spur, 0, 4)) ==
          std::vector{0, 4, 0, 1, 2, 3});
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_vertices(he, i) == expected.face_vertices(i));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(face_vertices(he, i) == expected.face_vertices(i));
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one face?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::has_face,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE(face_vertices(he, at.row()) ==
                    at.vertices(expected.face_vertices(at.i)));
        });
}
