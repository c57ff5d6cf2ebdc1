// Hidden suite of tip.
#include "exercises/00_table/tip.h"
#include "course/runner/suite.h"
#include "grader/suites/00_table/by_definition.h"
#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::row;

TEST_CASE("tips of half-edges that have a face, on every mesh", "[points:3]") {
    hint("Which half-edges leave the vertex where i ends? Name two.");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            if (row(fixture, i).fi != -1)
                CHECK(tip(fixture.he, i) == oracle::arrives_at(fixture, i));
    }
}

TEST_CASE("tips of half-edges on the border of every mesh", "[points:1]") {
    hint("Do next and opp say the same on the border as in a face?");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            if (row(fixture, i).fi == -1)
                CHECK(tip(fixture.he, i) == oracle::arrives_at(fixture, i));
    }
}

TEST_CASE("both tips of an edge without any face", "[points:1]") {
    hint("Where does the walk go when it has come to a loose end?");
    for (const Fixture& fixture :
         {zoo::dangling(), renumbered(zoo::dangling())}) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        const auto [a, b] = fixture.mesh.loose_edges.at(0);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const HalfEdge& half_edge = row(fixture, i);
            if (half_edge.fi == -1 && row(fixture, half_edge.opp).fi == -1)
                CHECK(tip(fixture.he, i) == (half_edge.vi == a ? b : a));
        }
    }
}

TEST_CASE("tips on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& fixture) {
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            REQUIRE(tip(fixture.he, i) == oracle::arrives_at(fixture, i));
    });
}

TEST_CASE("a tip costs a fixed number of reads", "[points:1][large]") {
    hint("Must you look at any half-edge but a neighbour of i?");
    const LargeMesh& large = a_million_half_edges();
    hidden::for_each_asked(
        large, some_of(large, many_calls), 3 * 2 + 8,
        [](const HalfEdgeTable& he, const InLargeMesh& at) {
            const int v = oracle::arrives_at(at.mesh->tile, at.i);
            REQUIRE(tip(he, at.row()) == at.mesh->vertices(v, at.copy));
        });
}
