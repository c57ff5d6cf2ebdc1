// Hidden suite of is_closed. A guess is right half the time: each case asks
// for both answers, many times.
#include "exercises/04_topology/is_closed.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/02_border/meshes.h"
#include "grader/suites/04_topology/topology_meshes.h"
#include "grader/suites/04_topology/topology_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_closed(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK(is_closed(fixture.he) ==
          oracle::every_edge_has_two_faces(fixture.mesh));
}

/// The rows moved on by so many, the last ones to the front.
HalfEdgeTable moved_on(const HalfEdgeTable& he, int by) {
    const int n = he.size();
    std::vector<HalfEdge> rows(he.rows());
    for (int i = 0; i < n; ++i) {
        HalfEdge row = he.rows()[static_cast<std::size_t>(i)];
        row.next = (row.next + by) % n;
        row.opp = (row.opp + by) % n;
        rows[static_cast<std::size_t>((i + by) % n)] = row;
    }
    return HalfEdgeTable(rows);
}

/// The mesh without one face.
Fixture without_face(const Fixture& fixture, int face) {
    IndexedMesh mesh{fixture.mesh.positions, {}, {}};
    for (int f = 0; f < fixture.mesh.faces.size(); ++f)
        if (f != face) mesh.faces.push_back(fixture.mesh.faces[f]);
    return hidden::with_table_built(fixture.name + ", a face taken out", mesh);
}

}  // namespace

TEST_CASE("surfaces with holes and without", "[points:2]") {
    hint("Do handles matter, or how many sides the faces have?");
    for (int handles = 0; handles <= 3; ++handles)
        for (int holes = 0; holes <= 2; ++holes)
            check_closed(hidden::with_table_built(
                std::to_string(handles) + " handles, " + std::to_string(holes) +
                    " holes",
                hidden::surface_of_genus(handles, holes)));
    for (const Fixture& fixture :
         {zoo::house(), zoo::lens(), hidden::prism(), hidden::twelve_gon(),
          hidden::bipyramid(), hidden::windows(), hidden::ring_closed(),
          hidden::ring_of_two(), hidden::gaps(), zoo::triangle()})
        check_closed(fixture);
}

TEST_CASE("any one face taken out opens the mesh", "[points:2]") {
    hint("Is a single half-edge without a face enough, wherever it stands?");
    for (const Fixture& whole :
         {zoo::cube(), zoo::torus7(), hidden::ring_closed()}) {
        check_closed(whole);
        for (int f = 0; f < whole.mesh.faces.size(); ++f)
            check_closed(without_face(whole, f));
    }
}

TEST_CASE("several components", "[points:2]") {
    hint("One component is closed. What does that say about the others?");
    check_closed(hidden::open_then_closed());
    check_closed(hidden::closed_then_open());
    check_closed(hidden::two_tori());
    check_closed(zoo::hourglass());
    const IndexedMesh ball = icosphere(1);
    const IndexedMesh disk = grid(1, 1);
    for (int open = 0; open < 5; ++open) {
        std::vector<IndexedMesh> parts(4, ball);
        if (open < 4) parts[static_cast<std::size_t>(open)] = disk;
        check_closed(hidden::with_table_built("four parts",
                                              hidden::side_by_side(parts)));
    }
}

TEST_CASE("one open edge, in every row of the table", "[points:1]") {
    hint("Which rows does your loop look at: the first, too, and the last?");
    for (const Fixture& fixture :
         {hidden::loose_edge_after(), zoo::triangle(), zoo::tetra(),
          hidden::with_table_built("tetrahedron and loose edge",
                                   {std::vector<Vec3>{{0, 0, 0},
                                                      {1, 0, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {2, 0, 0},
                                                      {3, 0, 0}},
                                    zoo::tetra().mesh.faces,
                                    {{4, 5}}})})
        for (int by = 0; by < fixture.he.size(); ++by) {
            INFO(fixture.name << ", rows moved on by " << by);
            CHECK(is_closed(moved_on(fixture.he, by)) ==
                  oracle::every_edge_has_two_faces(fixture.mesh));
        }
}

TEST_CASE("faces on both sides of an edge, loose edges, no edge",
          "[points:1]") {
    hint("What about an edge with the same on both sides: a face, or none?");
    CHECK(is_closed(HalfEdgeTable()));
    CHECK_FALSE(is_closed({{0, -1, 1, 1}, {1, -1, 0, 0}}));
    // A single face on a sphere, cut from 0 to 1.
    CHECK(is_closed({{0, 0, 1, 1}, {1, 0, 0, 0}}));
    for (const Fixture& fixture : hidden::made_by_hand())
        if (!fixture.mesh.loose_edges.empty()) check_closed(fixture);
    check_closed(hidden::spur());
    check_closed(hidden::keyhole());
    check_closed(hidden::pinched_sphere());
    check_closed(hidden::checkered_octahedron());
}

TEST_CASE("renumbered and generated meshes", "[points:2]") {
    hint("Does your answer depend on which row stands first?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), hidden::generated_borders()})
        for (const Fixture& fixture : fixtures) check_closed(fixture);
    for (std::uint64_t k = 0; k < 10; ++k) {
        RandomMesh options;
        options.faces = 30;
        options.parts = 2;
        options.surface = Surface::closed;
        const Fixture whole = hidden::with_table_built(
            "generated", random_polygons(seed() * 100 + k, options));
        check_closed(renumbered(whole, k));
        check_closed(renumbered(without_face(whole, 3), k));
    }
}

TEST_CASE("a few reads for each half-edge", "[points:1]") {
    hint("Must a row be read again that was seen to have a face?");
    const Fixture whole = hidden::with_table_built("torus", torus(30, 30));
    for (const Fixture& fixture : {whole, without_face(whole, 899)}) {
        const OnMesh on(fixture);
        const ReadBudget budget(fixture.he, 8 * fixture.he.size());
        CHECK(is_closed(fixture.he) == (fixture.mesh.faces.size() == 900));
    }
}
