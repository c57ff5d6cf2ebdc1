// Hidden suite of euler.
#include "exercises/04_topology/euler.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_euler(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(euler(fixture.he) == oracle::topology_counts(fixture).euler());
}

/// A mesh of which the characteristic is known by what it is.
void check_surface(const std::string& name, const IndexedMesh& mesh,
                   int expected) {
    const Fixture fixture = hidden::with_table_built(name, mesh);
    const OnMesh on(fixture);
    CHECK(euler(fixture.he) == expected);
}

}  // namespace

TEST_CASE("spheres of every kind have 2", "[points:2]") {
    hint("Do faces of many sides count more than triangles?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::house(), zoo::pillow(), hidden::prism(),
          hidden::bipyramid(), hidden::ring_closed(),
          hidden::pinched_sphere()}) {
        const OnMesh on(fixture);
        CHECK(euler(fixture.he) == 2);
    }
    check_surface("icosphere", icosphere(2), 2);
}

TEST_CASE("tori, one and several holes through", "[points:2]") {
    hint("May the result be 0, or less than that?");
    check_surface("torus", torus(9, 5), 0);
    check_surface("torus of triangles", torus(4, 7, Cells::triangles), 0);
    check_surface("double torus", hidden::surface_of_genus(2, 0), -2);
    check_surface("triple torus", hidden::surface_of_genus(3, 0), -4);
    check_euler(zoo::torus7());
    check_euler(hidden::two_tori());
}

TEST_CASE("surfaces with a border", "[points:2]") {
    hint("Is there a count that does not belong in the sum?");
    check_surface("grid", grid(5, 3), 1);
    check_surface("sphere, four holes", hidden::surface_of_genus(0, 4), -2);
    check_surface("torus, one hole", hidden::surface_of_genus(1, 1), -1);
    check_surface("double torus, three holes", hidden::surface_of_genus(2, 3),
                  -5);
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::lens(), zoo::fan6(), hidden::twelve_gon(),
          hidden::windows(), hidden::ring_of_two(), hidden::spur(),
          hidden::keyhole(), hidden::gaps()})
        check_euler(fixture);
}

TEST_CASE("several components add up", "[points:1]") {
    hint("What has the result to do with how many parts there are?");
    check_euler(zoo::two_triangles());
    check_euler(hidden::open_then_closed());
    check_euler(hidden::closed_then_open());
    check_surface("two spheres",
                  hidden::side_by_side({zoo::tetra().mesh, zoo::cube().mesh}),
                  4);
    check_surface("sphere, disk and double torus",
                  hidden::side_by_side({icosphere(1), grid(2, 2),
                                        hidden::surface_of_genus(2, 0)}),
                  1);
}

TEST_CASE("bow-ties, loose edges, no edge at all", "[points:1]") {
    hint("Count them as they are: which rule would you change, and why?");
    CHECK(euler(HalfEdgeTable()) == 0);
    check_euler(zoo::bow_tie_crossed());
    check_euler(zoo::bow_tie_separate());
    check_euler(zoo::hourglass());
    check_euler(hidden::pinwheel_across());
    check_euler(hidden::pinwheel_split());
    check_euler(hidden::checkered_octahedron());
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_euler(fixture);
}

TEST_CASE("numbers mean nothing, and generated meshes", "[points:2]") {
    hint("Does the result depend on how the elements are numbered?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), hidden::generated_borders()})
        for (const Fixture& fixture : fixtures) {
            check_euler(fixture);
            INFO(fixture.name << ", with gaps in the numbers");
            CHECK(euler(hidden::with_gaps(fixture.he)) ==
                  oracle::topology_counts(fixture).euler());
        }
}
