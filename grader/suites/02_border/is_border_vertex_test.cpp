// Hidden suite of is_border_vertex.
#include "exercises/02_border/is_border_vertex.h"

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

int vertex_of(const Fixture& fixture, int i) {
    return fixture.he.rows()[static_cast<std::size_t>(i)].vi;
}

/// Every vertex of the mesh, from each half-edge that leaves it.
void check_vertices(const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    for (const int i : oracle::sample(fixture.he))
        CHECK(is_border_vertex(fixture.he, i) ==
              border.touches(vertex_of(fixture, i)));
}

}  // namespace

TEST_CASE("meshes with one border", "[points:2]") {
    hint("The border may be anywhere round the vertex. When did you stop?");
    check_vertices(zoo::fan6());
    check_vertices(zoo::slide());
    check_vertices(zoo::lens());
    check_vertices(hidden::keyhole());
    check_vertices(hidden::fan_with_gap());
}

TEST_CASE("closed meshes, alone and beside an open one", "[points:1]") {
    hint("What do you answer when you are back and have met no border?");
    check_vertices(hidden::open_then_closed());
    check_vertices(hidden::closed_then_open());
    check_vertices(zoo::cube());
    check_vertices(zoo::torus7());
    check_vertices(hidden::bipyramid());
}

TEST_CASE("vertices with loose edges", "[points:1]") {
    hint("How many neighbours may a vertex have, and how few?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_vertices(fixture);
}

TEST_CASE("numbers of half-edges and faces mean nothing", "[points:1]") {
    hint("Which two steps take you to the next half-edge round a vertex?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_vertices(fixture);
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("How many edges can meet at a vertex?");
    for (const Fixture& fixture : hidden::generated_borders())
        check_vertices(fixture);
}

TEST_CASE("the cost does not grow with the mesh", "[points:1]") {
    hint("Which half-edges of the table can be at this vertex at all?");
    const Fixture& large = a_million_half_edges();
    const std::vector<HalfEdge>& rows = large.he.rows();
    const std::vector<int> border = oracle::border_rows(large.he);
    std::vector<bool> on_border(large.mesh.positions.size(), false);
    for (const int i : border)
        on_border[static_cast<std::size_t>(vertex_of(large, i))] = true;

    const int step = large.he.size() / many_calls;
    std::vector<int> asked;
    for (int k = 0; k < many_calls; ++k) {
        const int at_border =
            border[static_cast<std::size_t>(k) % border.size()];
        const int beside = rows[static_cast<std::size_t>(at_border)].opp;
        asked.push_back(k % 2 == 0 ? beside : k * step);
    }
    const AskAhead ahead(large.he, asked);
    for (const int i : asked) {
        const ReadBudget budget(large.he, 64);
        REQUIRE(is_border_vertex(large.he, i) ==
                on_border[static_cast<std::size_t>(vertex_of(large, i))]);
    }
}
