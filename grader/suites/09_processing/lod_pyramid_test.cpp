// Hidden suite of lod_pyramid. Meshes lie at points with whole coordinates, so
// that it is fixed which edges go.
#include "exercises/09_processing/lod_pyramid.h"

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/decimation.h"
#include "grader/suites/meshes.h"

using namespace course;
using decimation::scattered;
using editing::Content;

namespace {

std::vector<LevelOfDetail> pyramid_at(const HalfEdgeTable& he,
                                      const std::vector<Vec3>& positions,
                                      int levels) {
    const ReadBudget budget(he, std::int64_t{1} << 28);
    return lod_pyramid(he, positions, levels);
}

/// What the levels must say, by brute force.
std::vector<Content> expected_levels(const Fixture& fixture, int levels) {
    std::vector<Content> all = {editing::content_of(fixture.he)};
    while (static_cast<int>(all.size()) < levels) {
        const int faces = decimation::face_count(all.back());
        Content coarser = decimation::simplified(
            all.back(), fixture.mesh.positions, faces / 2);
        if (decimation::face_count(coarser) == faces) break;
        all.push_back(std::move(coarser));
    }
    return all;
}

double mean_length(const Content& content, const std::vector<Vec3>& positions) {
    double sum = 0;
    const auto edges = decimation::edges(content);
    for (const auto& [a, b] : edges)
        sum += length(positions[std::size_t(b)] - positions[std::size_t(a)]);
    return sum / double(edges.size());
}

void check(const Fixture& fixture, int levels) {
    const OnMesh on(fixture);
    INFO("at most " << levels << " levels");
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const std::vector<LevelOfDetail> got =
        pyramid_at(fixture.he, positions, levels);
    const std::vector<Content> expected = expected_levels(fixture, levels);
    REQUIRE(got.size() == expected.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
        INFO("level " << k);
        REQUIRE_THAT(got[k].he, editing::Says(expected[k]));
    }
}

void check_distances(const Fixture& fixture) {
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const std::vector<LevelOfDetail> got = pyramid_at(fixture.he, positions, 6);
    const std::vector<Content> expected = expected_levels(fixture, 6);
    REQUIRE(got.size() == expected.size());
    for (std::size_t k = 0; k < got.size(); ++k) {
        INFO("level " << k);
        CHECK_THAT(got[k].from, IsAbout(mean_length(expected[k], positions) /
                                        mean_length(expected[0], positions)));
    }
}

Fixture sphere() {
    return editing::made("sphere", icosphere(1));
}

/// Both meshes side by side.
Fixture beside(const Fixture& a, const Fixture& b) {
    IndexedMesh mesh = a.mesh;
    const int first = a.mesh.vertex_count();
    for (const Vec3& p : b.mesh.positions) mesh.positions.push_back(p);
    for (const FaceList::Face face : b.mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        for (int& v : corners) v += first;
        mesh.faces.push_back(corners);
    }
    return editing::made(a.name + " and " + b.name, mesh);
}

}  // namespace

TEST_CASE("closed meshes, down to the tetrahedron", "[points:2]") {
    hint("Which level is the next one made from, and how many faces has it?");
    for (const int levels : {2, 3, 4, 5, 6, 20})
        check(scattered(sphere(), 1, 1000), levels);
    check(scattered(editing::neck(), 2, 1000), 9);
    check(scattered(hidden::bipyramid(), 3, 1000), 9);
    check(scattered(editing::octahedron(), 4, 1000), 9);
}

TEST_CASE("open meshes and larger faces", "[points:1]") {
    hint("How do you count the faces of a mesh that has a border?");
    check(scattered(editing::made("grid", grid(5, 4, Cells::triangles)), 1, 50),
          9);
    check(scattered(editing::ribbon(), 2, 50), 9);
    check(scattered(hidden::prism(), 3, 50), 9);
    check(scattered(zoo::cube(), 4, 50), 9);
    check(scattered(hidden::twelve_gon(), 5, 50), 9);
    check(scattered(editing::hexagon_lid(), 6, 50), 9);
}

TEST_CASE("the distances", "[points:1]") {
    hint("Is each edge counted once, and is the mean that of level 0?");
    check_distances(scattered(sphere(), 5, 1000));
    check_distances(scattered(editing::ribbon(), 6, 1000));
    check_distances(scattered(hidden::prism(), 7, 1000));
    Fixture far = scattered(sphere(), 8, 1000);
    for (Vec3& p : far.mesh.positions) p = 0x1p-10 * (p + Vec3{1e4, 0, -3e4});
    check_distances(far);
    for (const Fixture& fixture : editing::generated_surfaces())
        check_distances(scattered(fixture, 9, 1000));
}

TEST_CASE("a mesh that cannot be halved", "[points:1]") {
    hint("Is a level with more than half of the faces, but fewer, a level?");
    const Fixture torus = zoo::torus7();
    check(scattered(torus, 1, 50), 5);
    check(scattered(beside(torus, editing::octahedron()), 2, 50), 5);
    check(scattered(beside(editing::octahedron(), torus), 3, 50), 5);
    check(scattered(beside(hidden::two_tori(), sphere()), 4, 50), 9);
    check(scattered(beside(zoo::tetra(), editing::ribbon()), 5, 50), 9);
    check(scattered(zoo::tetra(), 6, 50), 3);
    check(scattered(zoo::triangle(), 7, 50), 3);
    check(scattered(zoo::two_triangles(), 8, 50), 3);
}

TEST_CASE("numbers mean nothing, and those of faces may have gaps",
          "[points:1]") {
    hint("Is the largest face number the number of the faces?");
    for (const std::uint64_t salt : {1U, 2U, 3U}) {
        const Fixture fixture = scattered(renumbered(sphere(), salt), salt, 40);
        check(fixture, 4);
        check(editing::with_gaps_in_faces(fixture), 4);
    }
    for (const Fixture& fixture : editing::generated_surfaces())
        check(scattered(fixture, 9, 1000), 4);
}

TEST_CASE("few levels, no level, no mesh, no positions", "[points:1]") {
    hint("What comes first: the question how many levels, or a level?");
    const Fixture fixture = scattered(sphere(), 3, 1000);
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    check(fixture, 1);
    for (const int levels : {0, -1, -100})
        CHECK_THROWS_AS(pyramid_at(fixture.he, positions, levels),
                        std::invalid_argument);
    const std::vector<Vec3> few(positions.begin(), positions.end() - 1);
    for (const int levels : {2, 7})
        CHECK_THROWS_AS(pyramid_at(fixture.he, few, levels),
                        std::invalid_argument);
    const std::vector<LevelOfDetail> none = pyramid_at(HalfEdgeTable(), {}, 5);
    REQUIRE(none.size() == 1);
    CHECK(none[0].he.empty());
    CHECK_THAT(none[0].from, IsAbout(1));
}
