// Hidden suite of vertex_degree.
#include "exercises/01_traversal/vertex_degree.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("vertices with faces all round", "[points:2]") {
    hint("Which two steps bring you from one edge of the vertex to the next?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::interior)
                REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
}

TEST_CASE("vertices on the border, from each half-edge that leaves them",
          "[points:1]") {
    hint("Is the number of edges there the number of faces?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::border)
                REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
}

TEST_CASE("loose edges, bow-ties, and a face that is met twice", "[points:1]") {
    hint("Which edges does the walk from i meet before it is back?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::degenerate)
                REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
    const Fixture pair = hidden::loose_pair();
    const OnMesh on(pair);
    CHECK(vertex_degree(pair.he, hidden::half_edge(pair, 0, 1)) == 4);
    CHECK(vertex_degree(pair.he, hidden::half_edge(pair, 4, 0)) == 1);
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge(
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE(vertex_degree(he, i) == expected.vertex_degree(i));
        });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one vertex?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::starts_within,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE(vertex_degree(he, at.row()) ==
                    expected.vertex_degree(at.i));
        });
}
