// Hidden suite of edge_kind.
#include "exercises/02_border/edge_kind.h"

#include <array>

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/for_each_half_edge.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

EdgeKind kind_with(int faces) {
    constexpr std::array<EdgeKind, 3> kinds = {
        EdgeKind::dangling, EdgeKind::border, EdgeKind::interior};
    return kinds.at(static_cast<std::size_t>(faces));
}

/// Both sides of each edge of the mesh that has so many faces.
void check_edges_with(int faces, const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::Border border(fixture);
    const AskAhead ahead(fixture.he, oracle::sample(fixture.he));
    for (const int i : oracle::sample(fixture.he))
        if (border.faces_at(i) == faces)
            REQUIRE(edge_kind(fixture.he, i) == kind_with(faces));
}

void check_all_edges(const Fixture& fixture) {
    for (int faces = 0; faces <= 2; ++faces) check_edges_with(faces, fixture);
}

}  // namespace

TEST_CASE("edges between two faces, from both sides", "[points:2]") {
    hint("How many sides has an edge, and which of them did you ask?");
    for (const Fixture& fixture : hidden::made_by_hand())
        check_edges_with(2, fixture);
}

TEST_CASE("edges with one face, from both sides", "[points:2]") {
    hint("Which of the two half-edges of an edge may you be given?");
    for (const Fixture& fixture : hidden::made_by_hand())
        check_edges_with(1, fixture);
}

TEST_CASE("loose edges: on a border, in a row, on their own", "[points:1]") {
    hint(
        "A loose edge has no face here and none there. Which test comes "
        "first?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_all_edges(fixture);
}

TEST_CASE("numbers of half-edges and faces mean nothing", "[points:1]") {
    hint("Where does the table say which half-edge is on the other side?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_all_edges(fixture);
    on_generated_meshes(hidden::generated_borders(), check_all_edges);
}

TEST_CASE("the cost does not grow with the mesh", "[points:1][large]") {
    hint("Which field takes you to the other side without a search?");
    const LargeMesh& large = a_million_half_edges();
    const std::vector<HalfEdge>& rows = large.tile.he.rows();
    hidden::for_each_asked(
        large, some_of(large, many_calls), 16,
        [&](const HalfEdgeTable& he, const InLargeMesh& at) {
            const HalfEdge& row = rows[static_cast<std::size_t>(at.i)];
            const HalfEdge& opp = rows[static_cast<std::size_t>(row.opp)];
            REQUIRE(edge_kind(he, at.row()) ==
                    kind_with((row.fi != -1) + (opp.fi != -1)));
        });
}
