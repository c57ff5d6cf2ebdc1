// Hidden suite of winged. What stands on each side of an edge is looked up in
// the face list; only along the border it is read off the table. Edges are told
// by the vertices that they join, whatever their numbers.
#include "exercises/05_structures/winged.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/05_structures/winged_meshes.h"
#include "grader/suites/meshes.h"

using namespace course;
using hidden::Sides;

namespace {

using Ends = std::array<int, 2>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

Ends joining(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

Ends ends(const WingedEdge& edge) {
    return joining(edge.from, edge.to);
}

/// The ends of edge e of the answer; {-1, -1} if it has no edge e.
Ends ends(const WingedMesh& got, int e) {
    if (e < 0 || at(e) >= got.edges.size()) return {-1, -1};
    return ends(got.edges[at(e)]);
}

/// The answer, which has each edge of the mesh once: that is required here.
WingedMesh answer(const Fixture& fixture, const Sides& sides) {
    WingedMesh got = winged(fixture.he);
    REQUIRE(2 * got.edges.size() == at(fixture.he.size()));
    std::vector<Ends> expected, found;
    for (const auto& [from_to, side] : sides)
        if (from_to[0] < from_to[1]) expected.push_back(from_to);
    for (const WingedEdge& edge : got.edges) found.push_back(ends(edge));
    std::sort(found.begin(), found.end());
    REQUIRE(found == expected);
    return got;
}

void check_faces(const WingedMesh& got, const Sides& sides) {
    for (const WingedEdge& edge : got.edges) {
        INFO("edge from " << edge.from << " to " << edge.to);
        REQUIRE(edge.left == sides.at({edge.from, edge.to}).face);
        REQUIRE(edge.right == sides.at({edge.to, edge.from}).face);
    }
}

void check_wings(const WingedMesh& got, const Sides& sides) {
    for (const WingedEdge& edge : got.edges) {
        INFO("edge from " << edge.from << " to " << edge.to);
        const hidden::Side left = sides.at({edge.from, edge.to});
        const hidden::Side right = sides.at({edge.to, edge.from});
        REQUIRE(ends(got, edge.from_left) == joining(left.before, edge.from));
        REQUIRE(ends(got, edge.to_left) == joining(edge.to, left.after));
        REQUIRE(ends(got, edge.from_right) == joining(edge.from, right.after));
        REQUIRE(ends(got, edge.to_right) == joining(right.before, edge.to));
    }
}

/// The numbers that some side has as its start, or as its face.
template <class Number>
std::vector<char> in_use(const Sides& sides, Number number) {
    std::vector<char> used;
    for (const auto& side : sides) {
        const int k = number(side);
        if (k < 0) continue;
        if (at(k) >= used.size()) used.resize(at(k) + 1);
        used[at(k)] = 1;
    }
    return used;
}

void check_vertices(const WingedMesh& got, const Sides& sides) {
    const std::vector<char> used =
        in_use(sides, [](const auto& side) { return side.first[0]; });
    REQUIRE(got.vertex.size() == used.size());
    for (std::size_t v = 0; v < used.size(); ++v) {
        INFO("vertex " << v);
        const Ends noted = ends(got, got.vertex[v]);
        if (used[v] == 0)
            REQUIRE(got.vertex[v] == -1);
        else
            REQUIRE(std::count(noted.begin(), noted.end(),
                               static_cast<int>(v)) == 1);
    }
}

void check_face_edges(const WingedMesh& got, const Sides& sides) {
    const std::vector<char> used =
        in_use(sides, [](const auto& side) { return side.second.face; });
    REQUIRE(got.face.size() == used.size());
    for (std::size_t f = 0; f < used.size(); ++f) {
        INFO("face " << f);
        const int e = got.face[f];
        if (used[f] == 0) {
            REQUIRE(e == -1);
            continue;
        }
        REQUIRE((0 <= e && at(e) < got.edges.size()));
        const Ends noted = ends(got, e);
        REQUIRE((sides.at(noted).face == static_cast<int>(f) ||
                 sides.at({noted[1], noted[0]}).face == static_cast<int>(f)));
    }
}

void check_all(const Fixture& fixture) {
    const OnMesh on(fixture);
    const Sides sides = hidden::sides_of(fixture);
    const WingedMesh got = answer(fixture, sides);
    check_faces(got, sides);
    check_wings(got, sides);
    check_vertices(got, sides);
    check_face_edges(got, sides);
}

bool has_border(const Fixture& fixture) {
    return std::any_of(fixture.he.rows().begin(), fixture.he.rows().end(),
                       [](const HalfEdge& row) { return row.fi == -1; });
}

/// A large mesh under a budget of reads for each half-edge.
void check_cost(const IndexedMesh& mesh) {
    const Fixture fixture =
        renumbered({"large mesh", mesh, build(mesh)}, mesh.positions.size());
    const OnMesh on(fixture);
    const ReadBudget budget(fixture.he, 40 * std::int64_t{fixture.he.size()});
    const WingedMesh got = winged(fixture.he);
    CHECK(2 * got.edges.size() == at(fixture.he.size()));
    CHECK(got.vertex.size() == mesh.positions.size());
}

}  // namespace

TEST_CASE("each edge once, its two faces on the right sides", "[points:1]") {
    hint("Which half-edge lies on the left of an edge, seen from its start?");
    for (const Fixture& fixture : hidden::made_by_hand()) {
        const OnMesh on(fixture);
        const Sides sides = hidden::sides_of(fixture);
        check_faces(answer(fixture, sides), sides);
    }
}

TEST_CASE("the four neighbours of each edge of closed meshes", "[points:2]") {
    hint("Which of the four come before the edge, and which after it?");
    for (const Fixture& fixture : hidden::made_by_hand()) {
        if (has_border(fixture)) continue;
        const OnMesh on(fixture);
        const Sides sides = hidden::sides_of(fixture);
        check_wings(answer(fixture, sides), sides);
    }
}

TEST_CASE("the four neighbours where there is a border", "[points:1]") {
    hint("Does a half-edge without a face have one before and one after it?");
    for (const Fixture& fixture : hidden::made_by_hand()) {
        if (!has_border(fixture)) continue;
        const OnMesh on(fixture);
        const Sides sides = hidden::sides_of(fixture);
        check_wings(answer(fixture, sides), sides);
    }
}

TEST_CASE("an edge for each vertex and each face, also where numbers have gaps",
          "[points:1]") {
    hint("How long are the two lists, and what stands at an unused number?");
    std::vector<Fixture> fixtures = hidden::made_by_hand();
    Fixture sparse = zoo::slide();
    sparse.name = "slide, faces 2, 5 and 7";
    const int number[] = {5, 2, 7};
    for (HalfEdge& row : sparse.he)
        if (row.fi != -1) row.fi = number[row.fi];
    sparse.mesh.faces = {};
    fixtures.push_back(sparse);
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const Sides sides = hidden::sides_of(fixture);
        const WingedMesh got = answer(fixture, sides);
        check_vertices(got, sides);
        check_face_edges(got, sides);
    }
    CHECK(winged(HalfEdgeTable()) == WingedMesh());
}

TEST_CASE("numbers of half-edges, vertices and faces mean nothing",
          "[points:1]") {
    hint("Which of your steps relies on how the table is numbered?");
    for (const auto& fixtures :
         {hidden::renumbered_copies(), generated_fixtures()})
        for (const Fixture& fixture : fixtures) check_all(fixture);
}

TEST_CASE("a few reads for each half-edge", "[points:1]") {
    hint("What do you do again and again that could be done once for all?");
    check_cost(grid(40, 40));
    IndexedMesh large_face, large_fan;
    std::vector<int> corners;
    large_fan.positions.push_back({});
    constexpr int n = 1500;
    for (int k = 0; k < n; ++k) {
        const Vec3 point{std::cos(2e-3 * k), std::sin(2e-3 * k), 0};
        large_face.positions.push_back(point);
        large_fan.positions.push_back(point);
        corners.push_back(k);
        large_fan.faces.push_back({0, k + 1, (k + 1) % n + 1});
    }
    large_face.faces.push_back(corners);
    check_cost(large_face);
    check_cost(large_fan);
}
