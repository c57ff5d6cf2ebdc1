// Hidden suite of anchors. Any half-edge of a vertex or face is right; which
// vertices and faces have one comes from the face list.
#include "exercises/03_building/anchors.h"

#include <set>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

/// The vertices that a face or a loose edge uses.
std::set<int> used_vertices(const IndexedMesh& mesh) {
    std::set<int> used(mesh.faces.corners().begin(),
                       mesh.faces.corners().end());
    for (const auto& edge : mesh.loose_edges)
        used.insert(edge.begin(), edge.end());
    return used;
}

/// Each element has a half-edge with `number` there, or -1 where it is not in
/// `used`; no half-edge off the table is looked up.
void require_anchors(const HalfEdgeTable& he, const std::vector<int>& found,
                     int HalfEdge::*number, const std::set<int>& used,
                     const std::string& what) {
    int k = 0;
    for (const int i : found) {
        INFO(what << " " << k << " got half-edge " << i);
        if (used.contains(k)) {
            REQUIRE((0 <= i && i < he.size()));
            REQUIRE(he.rows()[static_cast<std::size_t>(i)].*number == k);
        } else {
            REQUIRE(i == -1);
        }
        ++k;
    }
}

/// With more numbers than the mesh has.
void check_anchors(const Fixture& fixture, int more_vertices, int more_faces) {
    const OnMesh on(fixture);
    const int vertices = fixture.mesh.vertex_count() + more_vertices;
    const int faces = fixture.mesh.faces.size() + more_faces;
    const Anchors found = anchors(fixture.he, vertices, faces);
    REQUIRE(std::ssize(found.vertex) == vertices);
    REQUIRE(std::ssize(found.face) == faces);
    require_anchors(fixture.he, found.vertex, &HalfEdge::vi,
                    used_vertices(fixture.mesh), "vertex");
    std::set<int> used;
    for (int f = 0; f < fixture.mesh.faces.size(); ++f) used.insert(f);
    require_anchors(fixture.he, found.face, &HalfEdge::fi, used, "face");
}

void check_both(const Fixture& fixture, std::uint64_t salt = 1) {
    check_anchors(fixture, 0, 0);
    check_anchors(renumbered(fixture, salt), 0, 0);
}

}  // namespace

TEST_CASE("closed meshes", "[points:1]") {
    hint("Does vertex v get a half-edge that leaves v, and face f one of f?");
    for (const Fixture& fixture : hidden::closed_meshes()) check_both(fixture);
}

TEST_CASE("open meshes", "[points:2]") {
    hint("What do half-edges on the border say about faces, and vertices?");
    for (const Fixture& fixture : hidden::open_meshes_with_table())
        check_both(fixture);
}

TEST_CASE("vertices that only the border leaves, or loose edges",
          "[points:1]") {
    hint("Is a half-edge without a face good enough for a vertex?");
    for (const Fixture& fixture : hidden::with_loose_edges())
        check_both(fixture);
    const HalfEdgeTable edge = {{0, -1, 1, 1}, {1, -1, 0, 0}};
    const Anchors found = anchors(edge, 2, 0);
    CHECK(found.vertex == std::vector<int>{0, 1});
    CHECK(found.face.empty());
}

TEST_CASE("numbers that nothing has get -1", "[points:2]") {
    hint("Which vertex is there if no half-edge leaves it?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::cube(), zoo::dangling(), hidden::gaps(),
          renumbered(hidden::gaps(), 3), renumbered(zoo::annulus(), 4)})
        for (const int more : {0, 1, 2, 30}) {
            check_anchors(fixture, more, 0);
            check_anchors(fixture, 0, more);
            check_anchors(fixture, more, 2 * more);
        }
}

TEST_CASE("an empty table", "[points:1]") {
    hint("How long are the lists if there is no half-edge at all?");
    const Anchors none = anchors(HalfEdgeTable(), 0, 0);
    CHECK(none.vertex.empty());
    CHECK(none.face.empty());
    const Anchors all = anchors(HalfEdgeTable(), 5, 2);
    CHECK(all.vertex == std::vector<int>(5, -1));
    CHECK(all.face == std::vector<int>(2, -1));
}

TEST_CASE("faces and vertices that are met twice", "[points:1]") {
    hint("Which of its half-edges does a face get? Is any of them right?");
    for (const Fixture& fixture :
         {hidden::spur(), hidden::keyhole(), hidden::pinched_sphere(),
          hidden::pinwheel_across(), hidden::pinwheel_split()})
        check_both(fixture);
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Does your answer hold however the half-edges are numbered?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_closed())
        check_both(fixture, ++salt);
    for (const Fixture& fixture : hidden::generated_open())
        check_both(fixture, ++salt);
}

TEST_CASE("a few reads for each half-edge", "[points:1]") {
    hint("How often do you look through the table?");
    const IndexedMesh mesh = grid(30, 25);
    const Fixture large = renumbered({"grid", mesh, build(mesh)});
    {
        const ReadBudget budget(large.he, 16 * std::int64_t{large.he.size()});
        check_anchors(large, 0, 0);
    }
    const Fixture slide = zoo::slide();
    const ReadBudget budget(slide.he, 16 * std::int64_t{slide.he.size()});
    check_anchors(slide, 5000, 5000);
}
