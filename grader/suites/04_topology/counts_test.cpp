// Hidden suite of counts.
#include "exercises/04_topology/counts.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

Counts expected_counts(const Fixture& fixture) {
    const oracle::TopologyCounts found = oracle::topology_counts(fixture);
    return {found.vertices, found.edges, found.faces, found.loops};
}

void check_counts(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(::counts(fixture.he) == expected_counts(fixture));
}

/// The table of an open mesh: loops that are long, and many.
struct Measured {
    HalfEdgeTable he;
    Counts counts;
};

/// One face with so many sides.
Measured polygon(int sides) {
    IndexedMesh mesh;
    std::vector<int> corners;
    for (int v = 0; v < sides; ++v) {
        mesh.positions.push_back({std::cos(0.01 * v), std::sin(0.01 * v), 0});
        corners.push_back(v);
    }
    mesh.faces.push_back(corners);
    return {build(mesh), {sides, sides, 1, 1}};
}

/// Triangles apart from each other.
Measured triangles(int n) {
    IndexedMesh mesh;
    for (int k = 0; k < n; ++k) {
        for (const double x : {0.0, 0.5, 1.0})
            mesh.positions.push_back({2.0 * k + x, x == 0.5 ? 1.0 : 0.0, 0});
        mesh.faces.push_back({3 * k, 3 * k + 1, 3 * k + 2});
    }
    return {build(mesh), {3 * n, 3 * n, n, n}};
}

}  // namespace

TEST_CASE("closed meshes", "[points:2]") {
    hint("What does one vertex, one edge and one face look like in the table?");
    check_counts(zoo::pillow());
    check_counts(zoo::house());
    check_counts(zoo::torus7());
    check_counts(zoo::hourglass());
    check_counts(hidden::prism());
    check_counts(hidden::bipyramid());
    check_counts(hidden::ring_closed());
    check_counts(hidden::two_tori());
    check_counts(hidden::pinched_sphere());
    check_counts(
        hidden::with_table_built("genus 2", hidden::surface_of_genus(2, 0)));
}

TEST_CASE("meshes with a border", "[points:2]") {
    hint("A half-edge without a face: what does it count for, what not?");
    check_counts(zoo::triangle());
    check_counts(zoo::annulus());
    check_counts(zoo::lens());
    check_counts(zoo::fan6());
    check_counts(zoo::two_triangles());
    check_counts(hidden::twelve_gon());
    check_counts(hidden::ring_of_two());
    check_counts(hidden::keyhole());
    check_counts(hidden::spur());
    check_counts(hidden::windows());
    check_counts(hidden::open_then_closed());
    check_counts(hidden::closed_then_open());
    check_counts(hidden::with_table_built("genus 1, three holes",
                                          hidden::surface_of_genus(1, 3)));
}

TEST_CASE("meshes with loose edges", "[points:1]") {
    hint("Has a loose edge a loop of its own, or does a loop pass it?");
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_counts(fixture);
    CHECK(::counts({{0, -1, 1, 1}, {1, -1, 0, 0}}) == Counts{2, 1, 0, 1});
}

TEST_CASE("vertices that the border passes more than once", "[points:1]") {
    hint("Is it by their vertices that you tell loops from each other?");
    check_counts(zoo::bow_tie_crossed());
    check_counts(zoo::bow_tie_separate());
    check_counts(hidden::pinwheel_in_turn());
    check_counts(hidden::pinwheel_across());
    check_counts(hidden::pinwheel_split());
    check_counts(hidden::checkered_octahedron());
    check_counts(renumbered(hidden::checkered_octahedron()));
}

TEST_CASE("numbers with gaps, and an empty table", "[points:1]") {
    hint("Do you count what occurs, or look for the largest number?");
    CHECK(::counts(HalfEdgeTable()) == Counts{0, 0, 0, 0});
    check_counts(hidden::gaps());
    for (const Fixture& fixture : hidden::made_by_hand()) {
        INFO(fixture.name << ", with gaps in the numbers");
        CHECK(::counts(hidden::with_gaps(fixture.he)) ==
              expected_counts(fixture));
    }
}

TEST_CASE("the order of the rows means nothing", "[points:1]") {
    hint("Which rows of the table may stand side by side?");
    for (const Fixture& fixture : hidden::renumbered_copies())
        check_counts(fixture);
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Several components, many loops: is each one counted, and once?");
    for (const Fixture& fixture : hidden::generated_borders())
        check_counts(fixture);
}

TEST_CASE("the cost grows with the table, not with its square",
          "[points:1][once]") {
    hint("How do you know, without walking again, that a loop was walked?");
    for (const Measured& large : {polygon(3000), triangles(1000)}) {
        const ReadBudget budget(large.he, 32 * std::int64_t{large.he.size()});
        CHECK(::counts(large.he) == large.counts);
    }
}
