// Hidden suite of components.
#include "exercises/04_topology/components.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_components(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(components(fixture.he) == oracle::graph_parts(fixture.mesh));
}

/// So many parts of different kinds, in an order that comes from the seed.
Fixture parts(int n, std::uint64_t salt) {
    const std::vector<IndexedMesh> kinds = {
        zoo::tetra().mesh, zoo::annulus().mesh, zoo::two_triangles().mesh,
        hidden::surface_of_genus(0, 2), grid(3, 2)};
    std::vector<IndexedMesh> chosen;
    for (const int k : hidden::any_order(n, salt))
        chosen.push_back(kinds[static_cast<std::size_t>(k) % kinds.size()]);
    return hidden::with_table_built(std::to_string(n) + " parts",
                                    hidden::side_by_side(chosen));
}

/// Loose edges 0-1, 1-2, ... in a row.
Fixture chain(int edges) {
    IndexedMesh mesh;
    for (int v = 0; v <= edges; ++v) mesh.positions.push_back({1.0 * v, 0, 0});
    for (int v = 0; v < edges; ++v) mesh.loose_edges.push_back({v, v + 1});
    return hidden::with_table_built("chain of loose edges", mesh);
}

}  // namespace

TEST_CASE("connected meshes, closed and open", "[points:2]") {
    hint("Does your search follow every edge, on the border, too?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::tetra(), zoo::house(), zoo::torus7(),
          zoo::pillow(), zoo::lens(), zoo::fan6(), hidden::prism(),
          hidden::twelve_gon(), hidden::ring_of_two(), hidden::ring_closed(),
          hidden::spur(), hidden::keyhole(), hidden::pinched_sphere(),
          hidden::windows(), hidden::gaps()})
        check_components(fixture);
}

TEST_CASE("meshes of several components", "[points:2]") {
    hint("What makes your search begin once more, and what makes it end?");
    check_components(hidden::open_then_closed());
    check_components(hidden::closed_then_open());
    check_components(hidden::two_tori());
    for (const int n : {2, 3, 5, 8}) {
        const Fixture fixture = parts(n, static_cast<std::uint64_t>(n));
        check_components(fixture);
        check_components(renumbered(fixture));
    }
}

TEST_CASE("parts that meet in one vertex only", "[points:2]") {
    hint("Two triangles share vertex 0. Can you go along edges through it?");
    for (const Fixture& fixture :
         {zoo::bow_tie_crossed(), zoo::bow_tie_separate(), zoo::hourglass(),
          hidden::pinwheel_in_turn(), hidden::pinwheel_across(),
          hidden::pinwheel_split(), hidden::checkered_octahedron()}) {
        check_components(fixture);
        check_components(renumbered(fixture));
    }
}

TEST_CASE("loose edges, hung on, between, and apart", "[points:1]") {
    hint("Does an edge need a face to join its two ends?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_components(fixture);
    check_components(chain(1));
    check_components(renumbered(chain(9)));
}

TEST_CASE("an empty table, and numbers with gaps", "[points:1]") {
    hint("Where do you keep what was seen, and for which vertex numbers?");
    CHECK(components(HalfEdgeTable()) == 0);
    for (const Fixture& fixture : hidden::made_by_hand()) {
        INFO(fixture.name << ", with gaps in the numbers");
        CHECK(components(hidden::with_gaps(fixture.he)) ==
              oracle::graph_parts(fixture.mesh));
    }
}

TEST_CASE("renumbered and generated meshes", "[points:2]") {
    hint("In which order do you meet the edges, and must it be that one?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), hidden::generated_borders()})
        for (const Fixture& fixture : fixtures) check_components(fixture);
}

TEST_CASE("the cost grows with the table, not with its square",
          "[points:1][once]") {
    hint("How often do you look at a half-edge that was looked at before?");
    const Fixture strip = renumbered(hidden::with_table_built(
        "long strip", hidden::side_by_side({hidden::triangle_strip(2500),
                                            hidden::triangle_strip(1500)})));
    const ReadBudget budget(strip.he, 32 * std::int64_t{strip.he.size()});
    CHECK(components(strip.he) == 2);
}
