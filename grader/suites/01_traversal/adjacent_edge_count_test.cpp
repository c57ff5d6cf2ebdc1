// Hidden suite of adjacent_edge_count.
#include "exercises/01_traversal/adjacent_edge_count.h"

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
                REQUIRE(adjacent_edge_count(he, i) ==
                        expected.adjacent_edge_count(i));
        });
}

TEST_CASE("faces at the border, and half-edges without a face", "[points:1]") {
    hint("On which side of the edge is the border: on yours or on the other?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::border)
                REQUIRE(adjacent_edge_count(he, i) ==
                        expected.adjacent_edge_count(i));
        });
}

TEST_CASE("faces that share several edges, and one that meets itself",
          "[points:1]") {
    hint("Do you count the sides with a neighbour, or the neighbours?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_face(i) == Place::degenerate)
                REQUIRE(adjacent_edge_count(he, i) ==
                        expected.adjacent_edge_count(i));
        });
    const Fixture lens = zoo::lens();
    const OnMesh on_lens(lens);
    CHECK(adjacent_edge_count(lens.he, hidden::half_edge(lens, 0, 1)) == 2);
    const Fixture spur = hidden::spur();
    const OnMesh on_spur(spur);
    CHECK(adjacent_edge_count(spur.he, hidden::half_edge(spur, 0, 1)) == 2);
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(adjacent_edge_count(he, i) ==
                    expected.adjacent_edge_count(i));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const ByFaces& expected) {
        REQUIRE(adjacent_edge_count(he, i) == expected.adjacent_edge_count(i));
    });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one face?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::has_face,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE(adjacent_edge_count(he, at.row()) ==
                    expected.adjacent_edge_count(at.i));
        });
}
