// Hidden suite of to_faces. What is expected are the faces that the table was
// made from.
#include "exercises/03_building/to_faces.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

std::vector<int> corners_of(FaceList::Face face) {
    return {face.begin(), face.end()};
}

void check_to_faces(const Fixture& fixture) {
    const OnMesh on(fixture);
    const std::vector<std::vector<int>> got = ::to_faces(fixture.he);
    REQUIRE(std::ssize(got) == fixture.mesh.faces.size());
    int f = 0;
    for (const std::vector<int>& face : got) {
        INFO("face " << f);
        REQUIRE_THAT(face, IsRotationOf(corners_of(fixture.mesh.faces[f])));
        ++f;
    }
}

/// As it is, and under other numbers.
void check_both(const Fixture& fixture, std::uint64_t salt = 1) {
    check_to_faces(fixture);
    check_to_faces(renumbered(fixture, salt));
}

Fixture with_built_table(const Fixture& fixture) {
    return {fixture.name, fixture.mesh, build(fixture.mesh)};
}

}  // namespace

TEST_CASE("closed meshes", "[points:2]") {
    hint("Do all faces have three sides?");
    for (const Fixture& fixture : hidden::closed_meshes()) check_both(fixture);
}

TEST_CASE("open meshes", "[points:2]") {
    hint(
        "What is `fi` of the half-edges on the border, and where may it lead?");
    for (const Fixture& fixture : hidden::open_meshes_with_table())
        check_both(fixture);
}

TEST_CASE("faces under other numbers stand at other places", "[points:2]") {
    hint("Does the first face that you meet have number 0?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::annulus(), zoo::cube(), zoo::house()})
        for (std::uint64_t salt = 2; salt < 10; ++salt)
            check_to_faces(renumbered(fixture, salt));
}

TEST_CASE("loose edges, and no face at all", "[points:1]") {
    hint("An edge with no face on either side: does it show in the result?");
    CHECK(::to_faces(HalfEdgeTable()).empty());
    CHECK(::to_faces({{0, -1, 1, 1}, {1, -1, 0, 0}}).empty());
    for (const Fixture& fixture : hidden::with_loose_edges())
        check_both(fixture);
}

TEST_CASE("a face that comes to a vertex twice", "[points:1]") {
    hint("Is the walk over when it meets a vertex again?");
    for (const Fixture& fixture :
         {hidden::spur(), hidden::keyhole(), hidden::pinched_sphere()})
        check_both(fixture);
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Faces of three to eight sides: does each come once and as a whole?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_closed())
        check_both(fixture, ++salt);
    for (const Fixture& fixture : hidden::generated_open())
        check_both(fixture, ++salt);
}

TEST_CASE("a few reads for each half-edge", "[points:1]") {
    hint("How many times do you walk round one face?");
    for (const Fixture& fixture :
         {hidden::of_mesh("grid", grid(30, 25)),
          hidden::of_mesh("torus", torus(12, 8, Cells::triangles))}) {
        const Fixture large = renumbered(with_built_table(fixture));
        const ReadBudget budget(large.he, 16 * std::int64_t{large.he.size()});
        check_to_faces(large);
    }
    IndexedMesh disk{std::vector<Vec3>(2000), {}, {}};
    std::vector<int> all;
    for (int v = 0; v < disk.vertex_count(); ++v) all.push_back(v);
    disk.faces.push_back(all);
    const HalfEdgeTable he = build(disk);
    const ReadBudget budget(he, 16 * std::int64_t{he.size()});
    const std::vector<std::vector<int>> faces = ::to_faces(he);
    REQUIRE(faces.size() == 1);
    REQUIRE(faces[0].size() == all.size());
    const bool same = IsRotationOf(all).match(faces[0]);
    CHECK(same);
}
