// Hidden suite of edge_vertices.
#include "exercises/00_table/edge_vertices.h"
#include "course/runner/suite.h"
#include "grader/suites/00_table/by_definition.h"
#include "grader/suites/for_each_half_edge.h"

using namespace course;
using oracle::row;

using Ends = std::array<int, 2>;

namespace {

Ends ends(const Fixture& fixture, int i) {
    return {row(fixture, i).vi, oracle::arrives_at(fixture, i)};
}

}  // namespace

TEST_CASE("edges of every mesh, from the side of a face", "[points:2]") {
    hint("Which half-edge leaves the other end, and which field leads there?");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            if (row(fixture, i).fi != -1)
                CHECK(edge_vertices(fixture.he, i) == ends(fixture, i));
    }
}

TEST_CASE("the start comes first, so the opposite gives them the other way",
          "[points:1]") {
    hint("Which of the two vertices does i leave?");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i) {
            const Ends there = edge_vertices(fixture.he, i);
            const int opp = row(fixture, i).opp;
            CHECK(edge_vertices(fixture.he, opp) == Ends{there[1], there[0]});
            CHECK(there[0] == row(fixture, i).vi);
        }
    }
}

TEST_CASE("edges on the border of every mesh, from the outside", "[points:1]") {
    hint("Does your way to the other end go through a face?");
    for (const Fixture& fixture : all_fixtures()) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            if (row(fixture, i).fi == -1)
                CHECK(edge_vertices(fixture.he, i) == ends(fixture, i));
    }
}

TEST_CASE("an edge without any face", "[points:1]") {
    hint("What are next and opp of a half-edge that arrives at a loose end?");
    for (const Fixture& fixture :
         {zoo::dangling(), renumbered(zoo::dangling())}) {
        const OnMesh on(fixture);
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        const auto [a, b] = fixture.mesh.loose_edges.at(0);
        for (int i = 0; i < fixture.he.size(); ++i) {
            const HalfEdge& half_edge = row(fixture, i);
            if (half_edge.fi != -1 || row(fixture, half_edge.opp).fi != -1)
                continue;
            const Ends expected = half_edge.vi == a ? Ends{a, b} : Ends{b, a};
            CHECK(edge_vertices(fixture.he, i) == expected);
        }
    }
}

TEST_CASE("ends of edges on generated meshes", "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    on_generated_meshes(generated_fixtures(), [](const Fixture& fixture) {
        const AskAhead ahead(fixture.he, all_half_edges(fixture.he));
        for (int i = 0; i < fixture.he.size(); ++i)
            REQUIRE(edge_vertices(fixture.he, i) == ends(fixture, i));
    });
}

TEST_CASE("two ends cost a fixed number of reads", "[points:1][large]") {
    hint("How many rows of the table must you look at for one edge?");
    const LargeMesh& large = a_million_half_edges();
    hidden::for_each_asked(large, some_of(large, many_calls), 3 * 3 + 8,
                           [](const HalfEdgeTable& he, const InLargeMesh& at) {
                               Ends expected = ends(at.mesh->tile, at.i);
                               for (int& v : expected)
                                   v = at.mesh->vertices(v, at.copy);
                               REQUIRE(edge_vertices(he, at.row()) == expected);
                           });
}
