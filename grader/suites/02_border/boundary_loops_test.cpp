// Hidden suite of boundary_loops.
#include "exercises/02_border/boundary_loops.h"

#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/02_border/oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_loops(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK_THAT(boundary_loops(fixture.he),
               AreLoops(oracle::Border(fixture).loops()));
}

/// One face of so many sides: half-edge k runs from vertex k along the face,
/// half-edge sides + k is its opposite.
HalfEdgeTable polygon(int sides) {
    std::vector<HalfEdge> rows;
    for (int k = 0; k < sides; ++k)
        rows.push_back({k, 0, (k + 1) % sides, sides + k});
    for (int k = 0; k < sides; ++k)
        rows.push_back(
            {(k + 1) % sides, -1, sides + (k + sides - 1) % sides, k});
    return HalfEdgeTable(rows);
}

}  // namespace

TEST_CASE("meshes with one border loop", "[points:1]") {
    hint("You met a half-edge of the loop again. Is that another loop?");
    check_loops(zoo::triangle());
    check_loops(zoo::lens());
    check_loops(zoo::fan6());
    check_loops(hidden::twelve_gon());
    check_loops(hidden::keyhole());
}

TEST_CASE("meshes with several border loops", "[points:1]") {
    hint("When the first loop is done, where do you look for the next one?");
    check_loops(zoo::annulus());
    check_loops(zoo::two_triangles());
    check_loops(hidden::ring_of_two());
    check_loops(hidden::windows());
    check_loops(renumbered(hidden::windows()));
    check_loops(hidden::open_then_closed());
    check_loops(hidden::closed_then_open());
}

TEST_CASE("an empty table and closed meshes have no loop", "[points:1]") {
    hint("What is your result before the first half-edge was looked at?");
    CHECK(boundary_loops(HalfEdgeTable()).empty());
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::cube(), zoo::torus7(), hidden::pinched_sphere()}) {
        const OnMesh on(fixture);
        CHECK(boundary_loops(fixture.he).empty());
    }
}

TEST_CASE("loops that pass a vertex twice", "[points:1]") {
    hint(
        "A loop may come to one vertex several times. What can it not repeat?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_loops(fixture);
    check_loops(zoo::bow_tie_crossed());
    check_loops(zoo::bow_tie_separate());
    check_loops(hidden::pinwheel_in_turn());
    check_loops(hidden::pinwheel_across());
    check_loops(hidden::pinwheel_split());
}

TEST_CASE("numbers of half-edges and faces mean nothing", "[points:1]") {
    hint("Is the next half-edge of the border also the next one in the table?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_loops(fixture);
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Does every half-edge without a face stand in exactly one loop?");
    on_generated_meshes(hidden::generated_borders(), check_loops);
}

TEST_CASE("the cost grows with the table, not with its square",
          "[points:1][once]") {
    hint("How do you know, without walking again, that a loop was walked?");
    constexpr int sides = 2000;
    const HalfEdgeTable he = polygon(sides);
    std::vector<int> loop;
    for (int k = sides; k > 0; --k) loop.push_back(sides + k - 1);
    const ReadBudget budget(he, 16 * he.size());
    CHECK_THAT(boundary_loops(he), AreLoops({loop}));
}
