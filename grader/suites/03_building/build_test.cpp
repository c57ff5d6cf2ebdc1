// Hidden suite of build. A table is right when it breaks no rule and has the
// faces and loose edges of the mesh, however its half-edges are numbered.
#include "exercises/03_building/build.h"

#include <set>

#include "course/mesh/generators.h"
#include "course/runner/is_table_of.h"
#include "course/runner/suite.h"
#include "grader/suites/03_building/building_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

void check_build(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK_THAT(::build(fixture.mesh), IsTableOf(fixture.mesh));
}

/// As it is, and put down in other ways.
void check_ways(const Fixture& fixture, std::uint64_t salt = 1) {
    check_build(fixture);
    check_build(hidden::put_in_another_order(fixture, salt));
    check_build(hidden::put_in_another_order(fixture, salt + 100));
}

void check_refused(const Fixture& fixture) {
    const OnMesh on(fixture);
    CHECK_THROWS_AS(::build(fixture.mesh), std::invalid_argument);
}

void check_refused_any_way(const Fixture& fixture, std::uint64_t salt = 1) {
    check_refused(fixture);
    check_refused(hidden::put_in_another_order(fixture, salt));
    check_refused(hidden::put_in_another_order(
        hidden::beside_each_other({zoo::annulus(), fixture, zoo::tetra()}),
        salt + 100));
}

/// The slide mesh with one face more.
Fixture with_face(const std::vector<int>& corners) {
    IndexedMesh mesh = zoo::slide().mesh;
    mesh.faces.push_back(corners);
    return hidden::of_mesh("slide mesh and one more face", mesh);
}

Fixture with_loose(const Fixture& fixture,
                   std::vector<std::array<int, 2>> ends) {
    IndexedMesh mesh = fixture.mesh;
    mesh.positions.resize(mesh.positions.size() + 3);
    mesh.loose_edges = std::move(ends);
    return hidden::of_mesh(fixture.name + ", loose edges", mesh);
}

/// How many half-edges of the table have no face, and how many loops of `next`
/// they form; -1 when next leaves the border.
std::array<int, 2> border(const HalfEdgeTable& he) {
    const std::vector<HalfEdge>& rows = he.rows();
    const auto n = rows.size();
    std::set<std::size_t> todo;
    for (std::size_t i = 0; i < n; ++i)
        if (rows[i].fi == -1) todo.insert(i);
    const int size = static_cast<int>(todo.size());
    int loops = 0;
    for (; !todo.empty(); ++loops) {
        auto i = *todo.begin();
        while (todo.erase(i) == 1) {
            const int next = rows[i].next;
            if (next < 0 || static_cast<std::size_t>(next) >= n)
                return {size, -1};
            i = static_cast<std::size_t>(next);
        }
    }
    return {size, loops};
}

}  // namespace

TEST_CASE("closed meshes have no border", "[points:1]") {
    hint("Is there anything in your table that no face runs along?");
    for (const Fixture& fixture : hidden::closed_meshes()) check_ways(fixture);
}

TEST_CASE("open meshes", "[points:2]") {
    hint("Where does `next` lead on the border, and is it the only one there?");
    for (const Fixture& fixture :
         {zoo::triangle(), zoo::slide(), zoo::annulus(), zoo::lens(),
          zoo::fan6(), hidden::twelve_gon(), hidden::ring_of_two(),
          hidden::of_mesh("grid", grid(4, 3)),
          hidden::of_mesh("grid of triangles", grid(3, 3, Cells::triangles))})
        check_ways(fixture);
}

TEST_CASE("the border is one loop, or several", "[points:1]") {
    hint("Count the half-edges without a face. In how many loops do they lie?");
    using Pair = std::array<int, 2>;
    CHECK(border(::build(zoo::slide().mesh)) == Pair{6, 1});
    CHECK(border(::build(zoo::annulus().mesh)) == Pair{6, 2});
    CHECK(border(::build(zoo::two_triangles().mesh)) == Pair{6, 2});
    CHECK(border(::build(zoo::fan6().mesh)) == Pair{6, 1});
    CHECK(border(::build(zoo::cube().mesh)) == Pair{0, 0});
}

TEST_CASE("several parts, and vertices that no face uses", "[points:1]") {
    hint("Does each vertex number have a half-edge?");
    for (const Fixture& fixture :
         {zoo::two_triangles(), hidden::gaps(), hidden::open_then_closed(),
          hidden::closed_then_open()})
        check_ways(fixture);
    check_ways(hidden::beside_each_other(
        {zoo::annulus(), zoo::cube(), zoo::slide(), zoo::triangle()}));
    CHECK(::build({}).empty());
    CHECK(::build({std::vector<Vec3>(4), {}, {}}).empty());
    IndexedMesh mesh{std::vector<Vec3>(140'000), {}, {}};
    mesh.faces = {{0, 65'536, 131'072}, {65'536, 0, 139'999}, {1, 0, 65'537}};
    CHECK_THAT(::build(mesh), IsTableOf(mesh));
}

TEST_CASE("the border comes to a vertex several times", "[points:2]") {
    hint("Two border half-edges leave a vertex. Does each follow another one?");
    for (std::uint64_t salt = 0; salt < 4; ++salt) {
        for (const Fixture& fixture :
             {zoo::bow_tie_crossed(), hidden::pinwheel_in_turn()})
            check_ways(fixture, salt);
        check_ways(hidden::of_faces(
                       "triangle beside a tetrahedron", 6,
                       {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}, {3, 4, 5}}),
                   salt);
        check_ways(
            hidden::of_faces("octahedron, every other face", 6,
                             {{0, 2, 4}, {1, 4, 3}, {1, 2, 5}, {0, 5, 3}}),
            salt);
    }
}

TEST_CASE("loose edges", "[points:1]") {
    hint("How many half-edges has a loose edge, and what comes after each?");
    for (const Fixture& fixture : hidden::with_loose_edges())
        check_ways(fixture);
    check_ways(with_loose(zoo::cube(), {{0, 8}, {9, 0}, {6, 0}, {8, 9}}));
    check_ways(with_loose(zoo::triangle(), {{3, 4}, {4, 5}, {3, 5}}));
    check_ways(with_loose(hidden::of_mesh("no faces", {}), {{2, 0}, {0, 1}}));
}

TEST_CASE("generated meshes", "[points:2]") {
    hint("Does your table depend on the order in which the faces come?");
    std::uint64_t salt = 0;
    for (const Fixture& fixture : hidden::generated_open())
        check_ways(fixture, ++salt);
    for (const Fixture& fixture : hidden::generated_closed())
        check_ways(fixture, ++salt);
}

TEST_CASE("more than two faces at an edge are refused", "[points:1]") {
    hint("What happens in your code when the third face of an edge comes?");
    for (std::uint64_t salt = 0; salt < 4; ++salt) {
        for (const Fixture& fixture : {zoo::fan3(), zoo::house_with_wall()})
            check_refused_any_way(fixture, salt);
        check_refused_any_way(
            hidden::of_faces("four pages", 6,
                             {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 0, 5}}),
            salt);
        check_refused_any_way(
            hidden::of_faces("a face twice", 4,
                             {{0, 1, 2}, {2, 1, 3}, {1, 2, 0}}),
            salt);
    }
}

TEST_CASE("faces wound alike are refused", "[points:1]") {
    hint("Two faces, and both run from a to b. Is there a table for that?");
    for (std::uint64_t salt = 0; salt < 4; ++salt) {
        for (const Fixture& fixture :
             {zoo::moebius3q(), zoo::moebius5(), zoo::klein4x4(), zoo::rp2_6()})
            check_refused_any_way(fixture, salt);
        for (int f = 0; f < 6; ++f)
            check_refused_any_way(hidden::with_faces_reversed(zoo::cube(), {f}),
                                  salt);
        for (int f = 0; f < 3; ++f)
            check_refused_any_way(
                hidden::with_faces_reversed(zoo::slide(), {f}), salt);
    }
}

TEST_CASE("faces that are no polygons are refused", "[points:1]") {
    hint("What makes a list of numbers a face? Do you check all of it?");
    for (const std::vector<int>& corners :
         std::vector<std::vector<int>>{{},
                                       {4},
                                       {3, 4},
                                       {3, 3, 4},
                                       {3, 4, 3},
                                       {4, 3, 3},
                                       {0, 3, 4, 3},
                                       {3, 0, 5, 4, 0, 1},
                                       {4, 3, -1},
                                       {4, 3, 6},
                                       {-2, 4, 3},
                                       {1 << 30, 3, 4},
                                       {3, 6, 4, 0}}) {
        INFO("the last face: " << show(corners));
        check_refused(with_face(corners));
    }
    check_build(with_face({3, 2, 0}));
    check_refused(hidden::of_faces("no vertices", 0, {{0, 1, 2}}));
    check_refused(hidden::of_faces("one edge", 2, {{0, 1}}));
}

TEST_CASE("loose edges that are none are refused", "[points:1]") {
    hint("Which pairs of vertices can have a loose edge between them?");
    const Fixture slide = zoo::slide();
    for (const auto& ends :
         std::vector<std::vector<std::array<int, 2>>>{{{6, 6}},
                                                      {{6, 9}},
                                                      {{-1, 6}},
                                                      {{6, 7}, {9, 6}},
                                                      {{6, 7}, {6, 7}},
                                                      {{6, 7}, {7, 8}, {7, 6}},
                                                      {{1, 2}},
                                                      {{2, 1}},
                                                      {{0, 1}},
                                                      {{1, 0}},
                                                      {{6, 7}, {4, 5}},
                                                      {{5, 4}, {6, 7}}})
        check_refused(with_loose(slide, ends));
    check_build(with_loose(slide, {{6, 7}, {7, 8}, {3, 4}}));
}

TEST_CASE("a large mesh", "[points:1][once]") {
    hint("How long does it take to find one opposite, or one next?");
    const Fixture large = hidden::put_in_another_order(
        hidden::of_mesh("large grid", grid(90, 100)), 5);
    const std::string why = difference(::build(large.mesh), large.mesh);
    CHECK(why.empty());
    IndexedMesh triangles{std::vector<Vec3>(24'000), {}, {}};
    for (int v = 0; v < triangles.vertex_count(); v += 3)
        triangles.faces.push_back({v, v + 1, v + 2});
    const std::string soup = difference(::build(triangles), triangles);
    CHECK(soup.empty());
}
