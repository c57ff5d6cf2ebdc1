// Hidden suite of adjacent_faces.
#include "exercises/01_traversal/adjacent_faces.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("faces with a neighbour along every side", "[points:2]") {
    hint("Which step goes on round the face, and which one only looks across?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::interior)
                REQUIRE_THAT(adjacent_faces(he, i),
                             IsPermutationOf(expected.adjacent_faces(i)));
        });
}

TEST_CASE("faces at the border, and half-edges without a face", "[points:1]") {
    hint("What is fi where there is no face, and is that a neighbour?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::border)
                REQUIRE_THAT(adjacent_faces(he, i),
                             IsPermutationOf(expected.adjacent_faces(i)));
        });
}

TEST_CASE("faces that share several edges, and one that meets itself",
          "[points:1]") {
    hint("How often may one face be in the list, and which face never?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::degenerate)
                REQUIRE_THAT(adjacent_faces(he, i),
                             IsPermutationOf(expected.adjacent_faces(i)));
        });
    const Fixture lens = zoo::lens();
    const OnMesh on_lens(lens);
    CHECK(adjacent_faces(lens.he, hidden::half_edge(lens, 0, 1)) ==
          std::vector{1});
    const Fixture spur = hidden::spur();
    const OnMesh on_spur(spur);
    CHECK(adjacent_faces(spur.he, hidden::half_edge(spur, 0, 1)).empty());
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE_THAT(adjacent_faces(he, i),
                         IsPermutationOf(expected.adjacent_faces(i)));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE_THAT(adjacent_faces(he, i),
                         IsPermutationOf(expected.adjacent_faces(i)));
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one face?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::has_face,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE_THAT(
                adjacent_faces(he, at.row()),
                IsPermutationOf(at.faces(expected.adjacent_faces(at.i))));
        });
}
