// Hidden suite of storage. What is expected is counted in the structures
// themselves, made for each mesh, or worked out by hand.
#include "exercises/04_topology/storage.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

/// Asks for the numbers of the mesh, whose structures are looked through.
void check_storage(const Fixture& fixture) {
    const OnMesh on(fixture);
    const oracle::TopologyCounts n = oracle::topology_counts(fixture);
    const oracle::StoredLists lists = oracle::stored_lists(fixture.mesh);
    int table = 0, winged = 0;
    for (int i = 0; i < fixture.he.size(); ++i) table += 4;
    for (int e = 0; e < n.edges; ++e) winged += 2 + 2 + 4;
    const Storage got = storage(Counts{n.vertices, n.edges, n.faces, n.loops},
                                oracle::side_count(fixture.mesh));
    CHECK(got.face_list == oracle::side_count(fixture.mesh));
    CHECK(got.half_edges == table);
    CHECK(got.half_edges_with_anchors == table + n.vertices + n.faces);
    CHECK(got.winged_edges == winged + n.vertices + n.faces);
    CHECK(got.adjacency_lists == lists.total());
}

}  // namespace

TEST_CASE("large closed meshes of triangles, and of quads", "[points:2]") {
    hint("V : F : E is 1 : 2 : 3 there, and 1 : 1 : 2. What follows?");
    // 3, 12, 13.5, 13.5 and 18 integers for each triangle.
    CHECK(storage(Counts{1000, 3000, 2000, 0}, 6000) ==
          Storage{6000, 24000, 27000, 27000, 36000});
    CHECK(storage(Counts{7, 21, 14, 0}, 42) == Storage{42, 168, 189, 189, 252});
    // 4, 16, 18, 18 and 24 for each quad.
    CHECK(storage(Counts{5000, 10000, 5000, 0}, 20000) ==
          Storage{20000, 80000, 90000, 90000, 120000});
    CHECK(storage(Counts{500'000, 1'500'000, 1'000'000, 0}, 3'000'000) ==
          Storage{3'000'000, 12'000'000, 13'500'000, 13'500'000, 18'000'000});
}

TEST_CASE("closed meshes, counted piece by piece", "[points:2]") {
    hint("Which lists name a face, which name an edge, which a vertex?");
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::house(), zoo::torus7(), zoo::pillow(),
          zoo::hourglass(), hidden::prism(), hidden::bipyramid(),
          hidden::ring_closed(), hidden::two_tori(), hidden::pinched_sphere()})
        check_storage(fixture);
}

TEST_CASE("open meshes, counted piece by piece", "[points:2]") {
    hint("An edge on the border: how many half-edges, and how many faces?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::annulus(), zoo::lens(), zoo::fan6(),
          zoo::two_triangles(), zoo::bow_tie_separate(), hidden::twelve_gon(),
          hidden::ring_of_two(), hidden::keyhole(), hidden::spur(),
          hidden::windows(), hidden::gaps(), hidden::open_then_closed()})
        check_storage(fixture);
}

TEST_CASE("loose edges, and no mesh at all", "[points:1]") {
    hint("Does a loose edge have faces to list? And half-edges?");
    CHECK(storage(Counts{0, 0, 0, 0}, 0) == Storage{0, 0, 0, 0, 0});
    CHECK(storage(Counts{2, 1, 0, 1}, 0) == Storage{0, 8, 10, 10, 4});
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_storage(fixture);
}

TEST_CASE("generated meshes", "[points:1]") {
    hint("Which of the four counts, and the corners, does each number need?");
    for (const Fixture& fixture : hidden::generated_borders())
        check_storage(fixture);
}
