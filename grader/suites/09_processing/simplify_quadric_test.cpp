// Hidden suite of simplify_quadric. Most meshes lie at points with small whole
// coordinates, so that errors are exact: the order of the collapses is then
// fixed, and the result, but for the numbers of its half-edges.
#include "exercises/09_processing/simplify_quadric.h"

#include <algorithm>
#include <set>

#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/decimation.h"
#include "grader/suites/meshes.h"

using namespace course;
using decimation::cut_cube;
using decimation::rounded;
using decimation::terrain;
using editing::Content;

namespace {

/// Simplifies under a budget that no honest answer uses up.
HalfEdgeTable simplify_at(const HalfEdgeTable& he,
                          const std::vector<Vec3>& positions, int faces) {
    const ReadBudget budget(he, std::int64_t{1} << 28);
    return simplify_quadric(he, positions, faces);
}

void check(const Fixture& fixture, const std::vector<int>& counts) {
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const Content content = editing::content_of(fixture.he);
    for (const int faces : counts) {
        INFO("to " << faces << " faces");
        const Content expected =
            decimation::simplified_by_planes(content, positions, faces);
        REQUIRE_THAT(simplify_at(fixture.he, positions, faces),
                     editing::Says(expected));
    }
}

/// One step, half of the way, and as far as it goes.
void check(const Fixture& fixture) {
    const int faces = fixture.mesh.faces.size();
    check(fixture, {faces - 1, faces / 2, 0});
}

Fixture sphere() {
    return editing::made("sphere", icosphere(1));
}

/// The contents of what comes back, which must be valid.
Content simplified(const Fixture& fixture, int faces) {
    const HalfEdgeTable got =
        simplify_at(fixture.he, fixture.mesh.positions, faces);
    REQUIRE(editing::broken_rule(got) == "");
    Content content = editing::content_of(got);
    for (const auto& [f, face] : content.faces) {
        REQUIRE(face.size() == 3);
        for (const int v : face) REQUIRE(v < fixture.mesh.vertex_count());
    }
    return content;
}

}  // namespace

TEST_CASE("closed meshes", "[points:2]") {
    hint("Which planes has each vertex, at the start and after each collapse?");
    check(rounded(sphere(), 1, 2));
    check(rounded(editing::octahedron(), 2, 4));
    check(rounded(hidden::bipyramid(), 3, 4));
    check(rounded(editing::neck(), 4, 3));
    check(rounded(editing::made("torus", torus(6, 4, Cells::triangles)), 5, 1));
}

TEST_CASE("open meshes, whose border stays", "[points:1]") {
    hint("May a vertex on the border go, and may another one be pulled there?");
    check(terrain(4, 3, 1, 3));
    check(terrain(5, 4, 2, 9));
    check(rounded(zoo::fan6(), 3, 1));
    check(rounded(editing::tube_of_three(), 4, 3));
    check(rounded(editing::ribbon(), 5, 3));
}

TEST_CASE("one collapse: which, and in which direction", "[points:1]") {
    hint("Both ends may stay. Is the error the same at both of them?");
    for (const std::uint64_t salt : {11U, 12U, 13U, 14U, 15U, 16U}) {
        check(rounded(sphere(), salt, 4), {78});
        check(rounded(editing::octahedron(), salt, 9), {6});
        check(rounded(hidden::bipyramid(), salt, 9), {16});
        check(terrain(4, 4, salt, 6), {31});
    }
}

TEST_CASE("equal errors", "[points:1]") {
    hint("Two pulls have the same error. Whose u is smaller, then whose v?");
    check(terrain(4, 4, 1, 0), {30, 24, 14, 0});
    check(terrain(5, 3, 2, 1), {26, 20, 0});
    check(renumbered(terrain(4, 4, 3, 0), 3), {30, 24, 14, 0});
    check(cut_cube(2), {46, 30, 12, 0});
    check(renumbered(cut_cube(2), 4), {30, 12});
    check(editing::octahedron(), {8, 20});
}

TEST_CASE("what is flat stays flat, with no triangle turned over",
          "[points:1]") {
    hint("In a plane all errors are 0. What keeps the mesh from folding?");
    for (const std::uint64_t salt : {0U, 1U, 2U}) {
        const Fixture fixture = renumbered(terrain(5, 5, 1, 0), salt);
        const OnMesh on(fixture);
        const std::vector<Vec3>& positions = fixture.mesh.positions;
        const Content content = simplified(fixture, 0);
        CHECK(content.borders == editing::content_of(fixture.he).borders);
        double area = 0;
        for (const auto& [f, face] : content.faces) {
            Content one;
            one.faces[f] = face;
            const Vec3 n = decimation::total_normal(one, positions);
            CHECK(n.z > 0);
            area += n.z;
        }
        CHECK_THAT(area, IsAbout(2.0 * 20 * 20));
    }
}

TEST_CASE("a cube keeps its corners and its volume", "[points:1]") {
    hint("Which vertices of a cube may go without any error?");
    for (const int n : {2, 3}) {
        const Fixture fixture = renumbered(cut_cube(n), std::uint64_t(n));
        const OnMesh on(fixture);
        const std::vector<Vec3>& positions = fixture.mesh.positions;
        const Content all = editing::content_of(fixture.he);
        const int some = 6 * n * n;
        const Content content = simplified(fixture, some);
        CHECK(decimation::face_count(content) <= some);
        CHECK_THAT(decimation::six_volumes(content, positions),
                   IsAbout(6.0 * n * n * n));
        std::set<int> vertices;
        for (const auto& [f, face] : content.faces)
            vertices.insert(face.begin(), face.end());
        for (int v = 0; v < fixture.mesh.vertex_count(); ++v) {
            const Vec3 p = positions[std::size_t(v)];
            const auto at_end = [&](double x) { return x == 0 || x == n; };
            if (at_end(p.x) && at_end(p.y) && at_end(p.z))
                CHECK(vertices.contains(v));
        }
    }
}

TEST_CASE("numbers mean nothing, nor do place, size and axes", "[points:1]") {
    hint("Does anything depend on numbers of half-edges, or on the origin?");
    for (const std::uint64_t salt : {1U, 2U}) {
        Fixture fixture = rounded(renumbered(sphere(), salt), salt, 2);
        check(fixture, {50, 10});
        for (Vec3& p : fixture.mesh.positions) p = p + Vec3{-70, 12, 100};
        check(fixture, {50});
        for (Vec3& p : fixture.mesh.positions)
            p = 0x1p-10 * Vec3{p.z, p.x, p.y};
        check(fixture, {50});
        for (Vec3& p : fixture.mesh.positions)
            p = 0x1p23 * Vec3{p.x, -p.z, p.y};
        check(fixture, {20});
    }
}

TEST_CASE("generated meshes, and face numbers with gaps", "[points:1]") {
    hint("Must faces be numbered without gaps, or a mesh have one part?");
    std::uint64_t salt = 20;
    for (const Fixture& fixture :
         editing::of_triangles(editing::generated_surfaces()))
        check(rounded(fixture, ++salt, 2));
    check(editing::with_gaps_in_faces(rounded(sphere(), 9, 2)), {60, 20});
    check(editing::with_gaps_in_faces(terrain(4, 4, 9, 5)), {25, 0});
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::torus7(), zoo::triangle(), zoo::two_triangles()})
        check(rounded(fixture, ++salt, 2), {0, 1, 3});
}

TEST_CASE("a round sphere stays closed and nearly round", "[points:1]") {
    hint("Is a vertex on a sphere ever far from the planes that it has?");
    const Fixture fixture = sphere();
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const double whole =
        decimation::six_volumes(editing::content_of(fixture.he), positions);
    double before = whole;
    for (const int faces : {70, 60, 50, 40}) {
        const Content content = simplified(fixture, faces);
        CHECK(content.borders.empty());
        CHECK(decimation::face_count(content) == faces);
        const double volume = decimation::six_volumes(content, positions);
        CHECK(volume > 0.7 * whole);
        CHECK(volume < before);
        before = volume;
    }
}

TEST_CASE("what cannot be simplified is refused", "[points:1]") {
    hint("Which questions come before the first position is read?");
    for (const Fixture& fixture :
         {zoo::slide(), zoo::house(), zoo::lens(), hidden::prism(),
          editing::one_quad(), editing::hexagon_lid()}) {
        const OnMesh on(fixture);
        for (const int faces : {0, 100})
            CHECK_THROWS_AS(
                simplify_at(fixture.he, fixture.mesh.positions, faces),
                std::invalid_argument);
    }
    const Fixture fixture = rounded(editing::octahedron(), 1, 1);
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const std::vector<Vec3> few(positions.begin(), positions.begin() + 5);
    CHECK_THROWS_AS(simplify_at(fixture.he, few, 4), std::invalid_argument);
    CHECK_THROWS_AS(simplify_at(fixture.he, few, 100), std::invalid_argument);
    CHECK_THROWS_AS(simplify_at(fixture.he, positions, -1),
                    std::invalid_argument);
    CHECK(simplify_at(fixture.he, positions, 8).size() == 24);
    CHECK(simplify_at(HalfEdgeTable(), {}, 0).empty());
}
