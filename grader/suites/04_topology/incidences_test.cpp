// Hidden suite of incidences.
#include "exercises/04_topology/incidences.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

Incidences expected_incidences(const Fixture& fixture) {
    const oracle::StoredLists lists = oracle::stored_lists(fixture.mesh);
    return {lists.faces_of_edges, lists.faces_of_vertices,
            lists.vertices_of_edges};
}

void check_incidences(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(incidences(fixture.he) == expected_incidences(fixture));
}

}  // namespace

TEST_CASE("closed meshes", "[points:1]") {
    hint("Faces of more than three sides: how many edges do they meet?");
    for (const Fixture& fixture :
         {zoo::cube(), zoo::torus7(), zoo::pillow(), zoo::hourglass(),
          hidden::prism(), hidden::bipyramid(), hidden::ring_closed(),
          hidden::two_tori()})
        check_incidences(fixture);
}

TEST_CASE("meshes with a border", "[points:2]") {
    hint("How many faces meet an edge on the border?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::annulus(), zoo::lens(), zoo::fan6(),
          zoo::two_triangles(), zoo::bow_tie_crossed(), zoo::bow_tie_separate(),
          hidden::twelve_gon(), hidden::ring_of_two(), hidden::windows(),
          hidden::gaps(), hidden::open_then_closed(),
          hidden::checkered_octahedron()})
        check_incidences(fixture);
}

TEST_CASE("loose edges, and no edge", "[points:1]") {
    hint("Which of the three numbers grow when an edge hangs on the mesh?");
    CHECK(incidences(HalfEdgeTable()) == Incidences{0, 0, 0});
    CHECK(incidences({{0, -1, 1, 1}, {1, -1, 0, 0}}) == Incidences{0, 0, 2});
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_incidences(fixture);
}

TEST_CASE("a face that meets an edge or a vertex twice", "[points:1]") {
    hint("Do you count faces, or meetings?");
    check_incidences(hidden::spur());
    check_incidences(hidden::keyhole());
    check_incidences(hidden::pinched_sphere());
    check_incidences(renumbered(hidden::keyhole()));
}

TEST_CASE("renumbered and generated meshes", "[points:2]") {
    hint("Does the order of the rows change who meets whom?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), hidden::generated_borders()})
        for (const Fixture& fixture : fixtures) {
            check_incidences(fixture);
            INFO(fixture.name << ", with gaps in the numbers");
            CHECK(incidences(hidden::with_gaps(fixture.he)) ==
                  expected_incidences(fixture));
        }
}

TEST_CASE("a few reads for each half-edge", "[points:1]") {
    hint("What does a row tell you, without a look at the others?");
    const Fixture large = hidden::with_table_built("grid", grid(40, 30));
    const OnMesh on(large);
    const ReadBudget budget(large.he, 32 * std::int64_t{large.he.size()});
    // 1200 quads; 40 * 31 edges one way, 41 * 30 the other way.
    CHECK(incidences(large.he) == Incidences{4800, 4800, 4940});
}
