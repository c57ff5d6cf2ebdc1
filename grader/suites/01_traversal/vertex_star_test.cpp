// Hidden suite of vertex_star.
#include "exercises/01_traversal/vertex_star.h"

#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::ByFaces;
using oracle::Place;

TEST_CASE("vertices with faces all round", "[points:2]") {
    hint(
        "After opp you are on the far side of the edge. Which half-edge "
        "brings you back to leave the vertex again?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::interior)
                REQUIRE_THAT(vertex_star(he, i),
                             IsRotationOf(expected.vertex_star(i)));
        });
}

TEST_CASE("vertices on the border, from each half-edge that leaves them",
          "[points:1]") {
    hint("What do you do when a half-edge has no face, and must you?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::border)
                REQUIRE_THAT(vertex_star(he, i),
                             IsRotationOf(expected.vertex_star(i)));
        });
}

TEST_CASE("loose edges, bow-ties, and a face that is met twice", "[points:1]") {
    hint(
        "When has the walk come back: at the same vertex, the same face, or "
        "the same half-edge?");
    hidden::for_each_half_edge(
        hidden::made_by_hand(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            if (expected.place_of_vertex(i) == Place::degenerate)
                REQUIRE_THAT(vertex_star(he, i),
                             IsRotationOf(expected.vertex_star(i)));
        });
    const Fixture chain = hidden::loose_chain();
    const OnMesh on(chain);
    CHECK(vertex_star(chain.he, hidden::half_edge(chain, 4, 3)) ==
          std::vector{3});
    CHECK_THAT(vertex_star(chain.he, hidden::half_edge(chain, 2, 3)),
               IsRotationOf({0, 3, 1}));
}

TEST_CASE("the numbers of half-edges, faces and vertices mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    hidden::for_each_half_edge(
        hidden::renumbered_copies(),
        [](const HalfEdgeTable& he, int i, const ByFaces& expected) {
            REQUIRE_THAT(vertex_star(he, i),
                         IsRotationOf(expected.vertex_star(i)));
        });
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Is there a number in your code that no mesh has promised?");
    for_each_generated_half_edge([](const HalfEdgeTable& he, int i,
                                    const ByFaces& expected) {
        REQUIRE_THAT(vertex_star(he, i), IsRotationOf(expected.vertex_star(i)));
    });
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("How many half-edges of the table must you look at for one vertex?");
    hidden::for_some_of_a_million(
        many_calls, 200, hidden::starts_within,
        [](const HalfEdgeTable& he, const InLargeMesh& at,
           const ByFaces& expected) {
            REQUIRE_THAT(vertex_star(he, at.row()),
                         IsRotationOf(at.vertices(expected.vertex_star(at.i))));
        });
}
