// Hidden suite of simplify. Most meshes lie at points with whole coordinates,
// so that lengths are exact: the order of the collapses is then fixed, and the
// result, but for the numbers of its half-edges.
#include "exercises/09_processing/simplify.h"

#include <set>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/decimation.h"
#include "grader/suites/meshes.h"

using namespace course;
using decimation::scattered;
using editing::Content;

namespace {

/// Simplifies under a budget that no honest answer uses up.
HalfEdgeTable simplify_at(const HalfEdgeTable& he,
                          const std::vector<Vec3>& positions, int faces) {
    const ReadBudget budget(he, std::int64_t{1} << 28);
    return simplify(he, positions, faces);
}

void check(const Fixture& fixture, const std::vector<int>& counts) {
    const OnMesh on(fixture);
    const std::vector<Vec3>& positions = fixture.mesh.positions;
    const Content content = editing::content_of(fixture.he);
    for (const int faces : counts) {
        INFO("to " << faces << " faces");
        const Content expected =
            decimation::simplified(content, positions, faces);
        REQUIRE_THAT(simplify_at(fixture.he, positions, faces),
                     editing::Says(expected));
    }
}

/// One step, half of the way, and as far as it goes.
void check(const std::vector<Fixture>& fixtures) {
    for (const Fixture& fixture : fixtures) {
        const int faces = fixture.mesh.faces.size();
        check(fixture, {faces - 1, faces / 2, 0});
    }
}

Fixture sphere() {
    return editing::made("sphere", icosphere(1));
}

std::vector<Fixture> closed() {
    return {editing::octahedron(), hidden::bipyramid(), editing::neck(),
            sphere(), renumbered(sphere(), 1)};
}

std::vector<Fixture> open() {
    return {editing::ribbon(),
            editing::made("grid", grid(4, 3, Cells::triangles)),
            hidden::gaps(),
            zoo::fan6(),
            editing::tube_of_three(),
            editing::made("tube", random_polygons(7, {.faces = 50,
                                                      .merge_percent = 0,
                                                      .hole_percent = 10}))};
}

}  // namespace

TEST_CASE("closed meshes", "[points:2]") {
    hint("After each collapse: which edge is the shortest now, and may it go?");
    check(scattered(closed(), 1000));
}

TEST_CASE("open meshes, where an end on the border stays", "[points:1]") {
    hint("One end is on the border, the other is not. Which of them goes?");
    check(scattered(open(), 1000));
}

TEST_CASE("edges of the same length", "[points:1]") {
    hint("Two edges are equally short. Whose smaller number is smaller?");
    check(scattered(closed(), 3));
    check(scattered(open(), 3));
    const Fixture flat = editing::made("grid", grid(4, 4, Cells::triangles));
    check(flat, {31, 20, 9, 0});
    check(renumbered(flat), {31, 20, 9, 0});
}

TEST_CASE("the shortest edge may not go, but another may", "[points:1]") {
    hint("Is it the end when the shortest edge of all is refused?");
    for (const double far : {1.0, 100.0}) {
        Fixture fixture = editing::neck();
        for (int v = 0; v < 17; ++v) {
            const double z = v < 6 || v == 15 ? -far : v < 9 ? 0 : far;
            const double r = 6 <= v && v < 9 ? 1 : 50 + v;
            fixture.mesh.positions[std::size_t(v)] = {r * (v % 3),
                                                      r * (v % 2) + v % 5, z};
        }
        check(fixture, {29, 20, 10, 4});
    }
}

TEST_CASE("as far as it goes: to the tetrahedron, or not at all",
          "[points:1]") {
    hint("How does your loop end when no edge is left that may go?");
    for (const Fixture& fixture : scattered(closed(), 100)) {
        const OnMesh on(fixture);
        const HalfEdgeTable got =
            simplify_at(fixture.he, fixture.mesh.positions, 0);
        CHECK(got.size() == 12);
        CHECK(editing::broken_rule(got) == "");
    }
    for (const Fixture& fixture :
         {zoo::tetra(), zoo::torus7(), hidden::two_tori(), zoo::triangle(),
          zoo::two_triangles()})
        check(scattered(fixture, 5, 100), {0, 1, 4});
}

TEST_CASE("exactly as many faces as asked for, or one fewer", "[points:1]") {
    hint("When is the number of faces small enough? Count by hand, from 8.");
    for (const int faces : {20, 19, 18, 17, 16, 80, 79, 81, 1000})
        check(scattered(sphere(), 3, 1000), {faces});
    for (int faces = 0; faces < 9; ++faces)
        check(scattered(editing::octahedron(), 4, 1000), {faces});
    for (int faces = 0; faces < 8; ++faces)
        check(scattered(editing::ribbon(), 5, 1000), {faces});
}

TEST_CASE("faces with more sides, and face numbers with gaps", "[points:1]") {
    hint("How do you count faces, and how many sides must they have for that?");
    check(scattered({zoo::slide(), zoo::cube(), zoo::house(), hidden::prism(),
                     editing::hexagon_lid(), hidden::twelve_gon()},
                    20));
    check(scattered(editing::generated_surfaces(), 100));
    for (const Fixture& fixture : {sphere(), editing::ribbon(), zoo::slide()})
        check(editing::with_gaps_in_faces(scattered(fixture, 6, 50)),
              {20, 4, 2, 0});
}

TEST_CASE("the numbers of half-edges mean nothing, nor does the place",
          "[points:1]") {
    hint("Does anything depend on numbers of half-edges, or on the origin?");
    for (const std::uint64_t salt : {1U, 2U, 3U}) {
        Fixture fixture = scattered(renumbered(sphere(), salt), salt, 40);
        check(fixture, {50, 10});
        for (Vec3& p : fixture.mesh.positions)
            p = 1024 * (p + Vec3{-70, 12, 300});
        check(fixture, {50, 10});
        for (Vec3& p : fixture.mesh.positions)
            p = 0x1p-20 * Vec3{p.z, -p.x, p.y};
        check(fixture, {50, 10});
    }
}

TEST_CASE("a round sphere stays a closed surface", "[points:1]") {
    hint("Is the table that you return valid, and closed, whatever the mesh?");
    const Fixture fixture = sphere();
    const OnMesh on(fixture);
    for (const int faces : {60, 40, 21, 5}) {
        const HalfEdgeTable got =
            simplify_at(fixture.he, fixture.mesh.positions, faces);
        REQUIRE(editing::broken_rule(got) == "");
        const Content content = editing::content_of(got);
        CHECK(content.borders.empty());
        CHECK(decimation::face_count(content) == faces / 2 * 2);
        std::set<int> vertices;
        for (const HalfEdge& row : got.rows()) vertices.insert(row.vi);
        CHECK(2 * int(vertices.size()) == faces / 2 * 2 + 4);
    }
}

TEST_CASE("a vertex without a position, and fewer faces than none",
          "[points:1]") {
    hint("Which questions come before the first position is read?");
    for (const Fixture& fixture :
         {editing::octahedron(), zoo::slide(), hidden::gaps()}) {
        const OnMesh on(fixture);
        const std::vector<Vec3>& positions = fixture.mesh.positions;
        int used = 0;
        for (const HalfEdge& row : fixture.he.rows())
            used = std::max(used, row.vi + 1);
        const std::vector<Vec3> few(positions.begin(),
                                    positions.begin() + used - 1);
        const std::vector<Vec3> enough(positions.begin(),
                                       positions.begin() + used);
        for (const int faces : {0, 2, 100})
            CHECK_THROWS_AS(simplify_at(fixture.he, few, faces),
                            std::invalid_argument);
        CHECK_THROWS_AS(simplify_at(fixture.he, {}, 100),
                        std::invalid_argument);
        CHECK_THROWS_AS(simplify_at(fixture.he, positions, -1),
                        std::invalid_argument);
        CHECK(simplify_at(fixture.he, enough, 100).size() == fixture.he.size());
    }
    CHECK(simplify_at(HalfEdgeTable(), {}, 0).empty());
}
