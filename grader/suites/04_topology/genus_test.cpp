// Hidden suite of genus.
#include "exercises/04_topology/genus.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_genus(const Fixture& fixture, int expected) {
    const OnMesh on(fixture);
    CHECK(genus(fixture.he) == expected);
}

void check_built(const std::string& name, const IndexedMesh& mesh,
                 int expected) {
    const Fixture fixture = hidden::with_table_built(name, mesh);
    check_genus(fixture, expected);
    check_genus(renumbered(fixture), expected);
}

std::string name_of(int handles, int holes) {
    return std::to_string(handles) + " handles, " + std::to_string(holes) +
           " holes";
}

/// The equation, with what the faces say about each number in it.
int by_equation(const Fixture& fixture) {
    const oracle::TopologyCounts n = oracle::topology_counts(fixture);
    return oracle::graph_parts(fixture.mesh) - (n.euler() + n.loops) / 2;
}

}  // namespace

TEST_CASE("closed surfaces", "[points:2]") {
    hint("What is the equation when S is 1 and B is 0?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::house(), zoo::pillow(), hidden::prism(),
          hidden::bipyramid(), hidden::ring_closed(), hidden::pinched_sphere()})
        check_genus(fixture, 0);
    check_built("torus of quads", torus(5, 4), 1);
    for (int handles = 0; handles <= 4; ++handles)
        check_built(name_of(handles, 0), hidden::surface_of_genus(handles, 0),
                    handles);
}

TEST_CASE("surfaces with a border and no handle", "[points:2]") {
    hint("What becomes of B on the way to G? And of a B that is odd?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::lens(), zoo::fan6(), hidden::twelve_gon(),
          hidden::ring_of_two(), hidden::spur(), hidden::keyhole(),
          hidden::gaps(), hidden::windows(), hidden::fan_with_gap()})
        check_genus(fixture, 0);
    check_built("grid", grid(4, 6), 0);
    for (int holes = 1; holes <= 4; ++holes)
        check_built(name_of(0, holes), hidden::surface_of_genus(0, holes), 0);
}

TEST_CASE("surfaces with handles and a border", "[points:2]") {
    hint("Do your signs and your division survive when G and B are not 0?");
    for (int handles = 1; handles <= 3; ++handles)
        for (int holes = 1; holes <= 4; ++holes)
            check_built(name_of(handles, holes),
                        hidden::surface_of_genus(handles, holes), handles);
}

TEST_CASE("several components", "[points:2]") {
    hint("What is S, and by what is it multiplied?");
    check_genus(zoo::two_triangles(), 0);
    check_genus(hidden::open_then_closed(), 0);
    check_genus(hidden::closed_then_open(), 0);
    check_genus(hidden::two_tori(), 2);
    const IndexedMesh sphere = icosphere(1);
    const IndexedMesh disk = grid(2, 3);
    const IndexedMesh torus = hidden::surface_of_genus(1, 0);
    const IndexedMesh open_double = hidden::surface_of_genus(2, 3);
    check_built("sphere and disk", hidden::side_by_side({sphere, disk}), 0);
    check_built("torus and sphere", hidden::side_by_side({torus, sphere}), 1);
    check_built("disk, double torus, torus",
                hidden::side_by_side({disk, open_double, torus}), 3);
    check_built(
        "five parts",
        hidden::side_by_side({open_double, sphere, open_double, disk, torus}),
        5);
}

TEST_CASE("loose edges, linked fans, no edge at all", "[points:1]") {
    hint("Does the equation need another rule for them?");
    CHECK(genus(HalfEdgeTable()) == 0);
    CHECK(genus({{0, -1, 1, 1}, {1, -1, 0, 0}}) == 0);
    for (const Fixture& fixture :
         {zoo::dangling(), hidden::loose_chain(), hidden::loose_pair(),
          hidden::thorn(), hidden::bridge(), hidden::loose_edge_after(),
          hidden::loose_edge_before(), zoo::bow_tie_crossed(),
          hidden::pinwheel_in_turn(), hidden::checkered_octahedron()})
        check_genus(fixture, 0);
}

TEST_CASE("generated and renumbered surfaces", "[points:1]") {
    hint("Does each number in the equation count what it should, and once?");
    for (const Fixture& fixture : generated_fixtures())
        check_genus(fixture, by_equation(fixture));
    for (const Fixture& fixture :
         {zoo::slide(), zoo::torus7(), zoo::annulus(), hidden::keyhole(),
          hidden::ring_of_two(), hidden::two_tori(), hidden::thorn()}) {
        const OnMesh on(fixture);
        check_genus(renumbered(fixture), by_equation(fixture));
        CHECK(genus(hidden::with_gaps(fixture.he)) == by_equation(fixture));
    }
    for (std::uint64_t k = 0; k < 4; ++k) {
        RandomMesh options;
        options.faces = 80;
        options.parts = 3;
        options.surface = k % 2 == 0 ? Surface::mixed : Surface::closed;
        const Fixture part = hidden::with_table_built(
            "generated", random_polygons(seed() * 100 + 20 + k, options));
        check_built(
            "generated, and a torus with holes",
            hidden::side_by_side({part.mesh, hidden::surface_of_genus(1, 2)}),
            by_equation(part) + 1);
    }
}
