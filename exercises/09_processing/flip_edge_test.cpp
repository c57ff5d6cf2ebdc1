#include "exercises/09_processing/flip_edge.h"

#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"

using namespace course;

namespace {

// 3---2     F0 = (0,1,2): half-edges 0, 1, 2
// |1/ |     F1 = (0,2,3): half-edges 3, 4, 5; 2 and 3 are opposites
// |/ 0|
// 0---1
Fixture square() {
    return {"square",
            {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
             {{0, 1, 2}, {0, 2, 3}},
             {}},
            {{0, 0, 1, 6},
             {1, 0, 2, 7},
             {2, 0, 0, 3},
             {0, 1, 4, 2},
             {2, 1, 5, 8},
             {3, 1, 3, 9},
             {1, -1, 9, 0},
             {2, -1, 6, 1},
             {3, -1, 7, 4},
             {0, -1, 8, 5}}};
}

}  // namespace

TEST_CASE("the diagonal of a square", "[points:1]") {
    hint("Which three half-edges does each triangle have afterwards?");
    const Fixture fixture = square();
    const OnMesh on(fixture);
    const HalfEdgeTable he = flip_edge(fixture.he, 2);
    CHECK_THAT(he,
               IsTableOf({fixture.mesh.positions, {{3, 1, 2}, {1, 3, 0}}, {}}));
    REQUIRE(he.size() == 10);
    CHECK(he[2].vi == 3);
    CHECK(he[3].vi == 1);
}

TEST_CASE("flipped four times, all is as it was", "[points:1]") {
    hint("By how much does the half-edge turn each time, and which way?");
    const Fixture fixture = square();
    const OnMesh on(fixture);
    HalfEdgeTable he = fixture.he;
    for (int k = 0; k < 4; ++k) he = flip_edge(he, 3);
    CHECK(he == fixture.he);
}

TEST_CASE("the border, larger faces and a tetrahedron are refused",
          "[points:1]") {
    hint("Is there a triangle on each side? Are the other corners joined yet?");
    const Fixture slide = zoo::slide();
    const OnMesh on(slide);
    CHECK_THROWS_AS(flip_edge(slide.he, 0), std::invalid_argument);
    CHECK_THROWS_AS(flip_edge(slide.he, 8), std::invalid_argument);
    CHECK_THROWS_AS(flip_edge(slide.he, 16), std::invalid_argument);
    CHECK_THROWS_AS(flip_edge(zoo::tetra().he, 0), std::invalid_argument);
}
