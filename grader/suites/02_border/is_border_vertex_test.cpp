// Hidden suite of is_border_vertex.
#include "exercises/02_border/is_border_vertex.h"

#include <set>

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/for_each_half_edge.h"
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
    const AskAhead ahead(fixture.he, oracle::sample(fixture.he));
    for (const int i : oracle::sample(fixture.he))
        REQUIRE(is_border_vertex(fixture.he, i) ==
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
    on_generated_meshes(hidden::generated_borders(), check_vertices);
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("Which half-edges of the table can be at this vertex at all?");
    const LargeMesh& large = a_million_half_edges();
    std::set<int> on_border;
    for (const int i : oracle::border_rows(large.tile.he))
        on_border.insert(vertex_of(large.tile, i));
    hidden::for_each_asked(
        large, some_of(large, many_calls), 64,
        [&](const HalfEdgeTable& he, const InLargeMesh& at) {
            REQUIRE(is_border_vertex(he, at.row()) ==
                    on_border.contains(vertex_of(large.tile, at.i)));
        });
}
