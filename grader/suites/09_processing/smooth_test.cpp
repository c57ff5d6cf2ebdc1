// Hidden suite of smooth. Expected positions come from the set of edges of the
// face list; the answer may have any length and any numbers.
#include "exercises/09_processing/smooth.h"

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/geometry.h"
#include "course/runner/suite.h"
#include "grader/suites/09_processing/smoothing_oracle.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

Fixture built(const std::string& name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {name, std::move(mesh), std::move(he)};
}

/// The fixture with rough positions in space, and a size for the matchers.
Fixture rough(Fixture fixture, std::uint64_t salt = 0) {
    fixture.mesh = hidden::roughened(fixture.mesh, salt);
    return fixture;
}

double size_of(const std::vector<Vec3>& positions) {
    double size = 1e-3;
    for (const Vec3 p : positions) size = std::max(size, length(p));
    return size;
}

void check_smooth(const Fixture& fixture, int steps, double w) {
    const OnMesh on(fixture);
    INFO("steps " << steps << ", w " << w);
    CHECK_THAT(smooth(fixture.he, fixture.mesh.positions, steps, w),
               AreAt(oracle::smoothed(fixture.mesh, steps, w),
                     size_of(fixture.mesh.positions)));
}

std::vector<Fixture> closed_meshes() {
    return {zoo::tetra(),
            zoo::cube(),
            zoo::house(),
            zoo::torus7(),
            zoo::pillow(),
            hidden::prism(),
            hidden::bipyramid(),
            hidden::two_tori(),
            hidden::ring_closed(),
            built("icosphere", icosphere(1)),
            built("torus of quads", torus(6, 4))};
}

std::vector<Fixture> open_meshes() {
    return {zoo::fan6(),
            zoo::annulus(),
            zoo::dangling(),
            hidden::keyhole(),
            hidden::thorn(),
            hidden::bridge(),
            hidden::open_then_closed(),
            hidden::closed_then_open(),
            built("grid of triangles", grid(5, 4, Cells::triangles)),
            built("grid of quads", grid(6, 3))};
}

}  // namespace

TEST_CASE("closed meshes, one step", "[points:2]") {
    hint("Which vertices does the mean take, and how often each?");
    for (const Fixture& mesh : closed_meshes()) {
        check_smooth(rough(mesh), 1, 0.5);
        check_smooth(renumbered(rough(mesh, 1), 1), 1, 0.5);
    }
}

TEST_CASE("all vertices move at once, in every step", "[points:2]") {
    hint("Does a vertex see neighbours that have moved in this step already?");
    for (const Fixture& mesh : closed_meshes()) {
        check_smooth(rough(mesh, 2), 2, 0.5);
        check_smooth(renumbered(rough(mesh, 3), 3), 3, 0.25);
        check_smooth(renumbered(rough(mesh, 4), 4), 6, 0.75);
    }
}

TEST_CASE("open meshes, where only some vertices move", "[points:2]") {
    hint("Which vertices are fixed? Do the others still move towards them?");
    for (const Fixture& mesh : open_meshes()) {
        check_smooth(rough(mesh, 5), 1, 0.5);
        check_smooth(rough(mesh, 6), 4, 0.5);
        check_smooth(renumbered(rough(mesh, 7), 7), 3, 0.75);
    }
}

TEST_CASE("vertices on the border keep their numbers exactly", "[points:1]") {
    hint("Both ends of a border edge: do you see them, for loose edges, too?");
    std::vector<Fixture> meshes = hidden::made_by_hand();
    for (const Fixture& mesh : generated_fixtures()) meshes.push_back(mesh);
    for (const Fixture& plain : meshes) {
        const Fixture mesh = rough(plain, 8);
        const OnMesh on(mesh);
        const std::vector<bool> moves = oracle::free_to_move(mesh.mesh);
        const auto got = smooth(mesh.he, mesh.mesh.positions, 3, 0.7);
        REQUIRE(got.size() == moves.size());
        for (std::size_t v = 0; v < moves.size(); ++v) {
            if (moves[v]) continue;
            INFO("vertex " << v);
            CHECK(got[v] == mesh.mesh.positions[v]);
        }
    }
}

TEST_CASE("every mesh, under every numbering", "[points:2]") {
    hint("Which numbers do you take to mean something that they do not?");
    for (const Fixture& mesh : hidden::made_by_hand())
        check_smooth(rough(mesh, 9), 2, 0.5);
    for (const Fixture& mesh : hidden::renumbered_copies())
        check_smooth(rough(mesh, 10), 2, 0.5);
    on_generated_meshes(generated_fixtures(), [](const Fixture& mesh) {
        check_smooth(rough(mesh, 11), 2, 0.5);
    });
}

TEST_CASE("w is used as it is", "[points:1]") {
    hint("Where does p + w (m - p) lie for w = 0, for w = 1, and outside?");
    for (const Fixture& plain : {zoo::fan6(), zoo::house(), zoo::torus7()}) {
        const Fixture mesh = rough(plain, 12);
        for (const double w : {1.0, 0.01, -0.5, 1.5, 2.0})
            for (const int steps : {1, 3}) check_smooth(mesh, steps, w);
        const OnMesh on(mesh);
        CHECK(smooth(mesh.he, mesh.mesh.positions, 5, 0) ==
              mesh.mesh.positions);
    }
}

TEST_CASE("no step leaves all as it was", "[points:1]") {
    hint("How often does your loop run when `steps` is 0?");
    for (const Fixture& plain : {zoo::cube(), zoo::slide(), zoo::fan6()}) {
        const Fixture mesh = rough(plain, 13);
        const OnMesh on(mesh);
        CHECK(smooth(mesh.he, mesh.mesh.positions, 0, 0.5) ==
              mesh.mesh.positions);
    }
}

TEST_CASE("what is flat stays flat, wherever it lies", "[points:1]") {
    hint("Does anything but the differences of positions go into a step?");
    const Fixture plain = renumbered(built("grid", grid(6, 5)), 14);
    for (const double scale : {1e-3, 1.0, 1e4}) {
        Fixture mesh = plain;
        for (Vec3& p : mesh.mesh.positions) {
            const double x = p.x + 0.3 * p.y * p.y, y = p.y - 0.2 * p.x * p.x;
            p = scale * Vec3{x, 5 + y, 2 * x - 3 * y};
        }
        check_smooth(mesh, 10, 0.5);
        const OnMesh on(mesh);
        const auto got = smooth(mesh.he, mesh.mesh.positions, 10, 0.5);
        REQUIRE(got.size() == mesh.mesh.positions.size());
        for (const Vec3 p : got)
            CHECK_THAT(p.z,
                       IsAbout(2 * p.x - 3 * (p.y - 5 * scale), 100 * scale));
    }
}

TEST_CASE("the same shape elsewhere gives the same shape", "[points:1]") {
    hint("Is the mesh near the origin? Is it about as large as 1?");
    for (const Fixture& plain : {zoo::torus7(), zoo::fan6(), zoo::house()}) {
        for (const double scale : {1e-3, 1.0, 1e4}) {
            Fixture mesh = rough(plain, 15);
            for (Vec3& p : mesh.mesh.positions)  // turned about z and moved
                p = scale * Vec3{0.6 * p.x - 0.8 * p.y + 30,
                                 0.8 * p.x + 0.6 * p.y - 20, p.z + 7};
            check_smooth(mesh, 3, 0.5);
        }
    }
}

TEST_CASE("several fans at a vertex count together", "[points:2]") {
    hint("A walk round a vertex meets one fan. Are there more?");
    for (const Fixture& mesh :
         {zoo::hourglass(), zoo::bow_tie_crossed(), zoo::bow_tie_separate(),
          hidden::pinched_sphere(), hidden::pinwheel_split()}) {
        check_smooth(rough(mesh, 16), 1, 0.5);
        check_smooth(renumbered(rough(mesh, 17), 17), 2, 0.9);
    }
}

TEST_CASE("vertices without an edge, and no mesh at all", "[points:1]") {
    hint("How many neighbours has a vertex that no half-edge leaves?");
    Fixture mesh = zoo::fan6();
    mesh.mesh.positions.push_back({9, -7, 5});
    mesh.mesh.positions.push_back({0, 0, 0});
    check_smooth(rough(mesh, 18), 2, 0.5);
    check_smooth(rough(hidden::gaps(), 19), 2, 0.5);
    check_smooth({"no faces", {{{1, 2, 3}, {4, 5, 6}}, {}, {}}, {}}, 2, 0.5);
    CHECK(smooth({}, {}, 3, 0.5).empty());
}

TEST_CASE("a negative number of steps is refused", "[points:1]") {
    hint("Which value of `steps` makes no sense?");
    const Fixture mesh = zoo::fan6();
    const OnMesh on(mesh);
    for (const int steps : {-1, -2, -1000000})
        CHECK_THROWS_AS(smooth(mesh.he, mesh.mesh.positions, steps, 0.5),
                        std::invalid_argument);
    CHECK_THROWS_AS(smooth({}, {}, -1, 0.5), std::invalid_argument);
}

TEST_CASE("a step is one pass over a large mesh", "[points:1][once]") {
    hint("For one vertex, how much of the table do you look through?");
    const Fixture mesh = built("large grid", grid(150, 150));
    const auto got = smooth(mesh.he, mesh.mesh.positions, 3, 0.5);
    CHECK_THAT(got, AreAt(mesh.mesh.positions, 150));
}
