// The hidden meshes. Faces and border loops are written out, so that no table
// here comes from the code that builds tables. A picture shows vertex numbers;
// letters are faces.
#include "grader/suites/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "course/runner/suite.h"

namespace course::hidden {

namespace {

using Loop = std::vector<int>;

/// Adds the half-edges of one loop of vertices; opposites are left open.
void append(std::vector<HalfEdge>& rows, const Loop& loop, int face) {
    const int first = static_cast<int>(rows.size());
    const int n = static_cast<int>(loop.size());
    for (int k = 0; k < n; ++k)
        rows.push_back(
            {loop[static_cast<std::size_t>(k)], face, first + (k + 1) % n, -1});
}

/// Sets each opposite: the half-edge between the same two vertices, back.
void link_opposites(std::vector<HalfEdge>& rows) {
    const auto tip = [&](const HalfEdge& row) {
        return rows[static_cast<std::size_t>(row.next)].vi;
    };
    std::map<std::array<int, 2>, int> by_ends;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (!by_ends.emplace(std::array{rows[i].vi, tip(rows[i])}, i).second)
            throw std::logic_error(
                fmt::format("half-edge {} runs from {} to "
                            "{}, as another one does",
                            i, rows[i].vi, tip(rows[i])));
    for (HalfEdge& row : rows) row.opp = by_ends.at({tip(row), row.vi});
}

/// A mesh from its faces and its border loops, both as loops of vertices.
Fixture from_loops(std::string name, std::vector<Vec3> positions,
                   const std::vector<Loop>& faces,
                   const std::vector<Loop>& borders,
                   std::vector<std::array<int, 2>> loose_edges = {}) {
    std::vector<HalfEdge> rows;
    IndexedMesh mesh{std::move(positions), {}, std::move(loose_edges)};
    for (const Loop& face : faces) {
        append(rows, face, mesh.faces.size());
        mesh.faces.push_back(face);
    }
    for (const Loop& border : borders) append(rows, border, -1);
    link_opposites(rows);
    return {std::move(name), std::move(mesh), HalfEdgeTable(std::move(rows))};
}

/// `n` points on a circle in the plane, counter-clockwise.
std::vector<Vec3> circle(int n, double radius, double z) {
    std::vector<Vec3> points;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        points.push_back(
            {radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return points;
}

std::vector<Vec3> joined(std::vector<Vec3> a, const std::vector<Vec3>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

const std::vector<Vec3> triangle_points = {{0, 0, 0}, {2, 0, 0}, {1, 2, 0}};
const std::vector<Vec3> tetra_points = {
    {4, 0, 0}, {6, 0, 0}, {5, 2, 0}, {5, 0.7, 2}};

/// The four triangles of a tetrahedron whose first vertex is `a`.
std::vector<Loop> tetra_faces(int a) {
    return {{a, a + 2, a + 1},
            {a, a + 1, a + 3},
            {a + 1, a + 2, a + 3},
            {a + 2, a, a + 3}};
}

}  // namespace

// twelve_gon: A = (0,1,...,11).           V,E,F = 12,12,1   chi 1   1 loop
Fixture twelve_gon() {
    Loop face, border;
    for (int v = 0; v < 12; ++v) {
        face.push_back(v);
        border.push_back(11 - v);
    }
    return from_loops("twelve-gon", circle(12, 2, 0), {face}, {border});
}

// prism: hexagons 0..5 below and 6..11 above, vertex k + 6 above vertex k.
//                                        V,E,F = 12,18,8   chi 2   closed
Fixture prism() {
    std::vector<Loop> faces = {{5, 4, 3, 2, 1, 0}, {6, 7, 8, 9, 10, 11}};
    for (int k = 0; k < 6; ++k) {
        const int after = (k + 1) % 6;
        faces.push_back({k, after, after + 6, k + 6});
    }
    return from_loops("prism", joined(circle(6, 2, -1), circle(6, 2, 1)), faces,
                      {});
}

// bipyramid: a ring 0..8, apex 9 above it and apex 10 below it.
//                                        V,E,F = 11,27,18   chi 2   closed
Fixture bipyramid() {
    std::vector<Loop> faces;
    for (int k = 0; k < 9; ++k) {
        const int after = (k + 1) % 9;
        faces.push_back({k, after, 9});
        faces.push_back({after, k, 10});
    }
    return from_loops("bipyramid",
                      joined(circle(9, 2, 0), {{0, 0, 2}, {0, 0, -2}}), faces,
                      {});
}

namespace {

const std::vector<Vec3> ring_points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0},
                                       {0, 3, 0}, {1, 1, 0}, {2, 1, 0},
                                       {2, 2, 0}, {1, 2, 0}};

}  // namespace

// ring_of_two: A and B share       3-------2
// the edges 0-4 and 2-6.           | B   / |
//                                  |  7-6  |
//                                  |  | |  |
//                                  |  4-5  |
//                                  | /   A |
//                                  0-------1
//                                        V,E,F = 8,10,2   chi 0   2 loops
Fixture ring_of_two() {
    return from_loops("ring of two", ring_points,
                      {{0, 1, 2, 6, 5, 4}, {2, 3, 0, 4, 7, 6}},
                      {{0, 3, 2, 1}, {4, 5, 6, 7}});
}

// ring_closed: the same on a sphere, with C = (4,5,6,7) inside the ring and
// D = (0,3,2,1) outside. On the way round A come B, C, B again, and D.
//                                        V,E,F = 8,10,4   chi 2   closed
Fixture ring_closed() {
    return from_loops(
        "ring closed", ring_points,
        {{0, 1, 2, 6, 5, 4}, {2, 3, 0, 4, 7, 6}, {4, 5, 6, 7}, {0, 3, 2, 1}},
        {});
}

// gaps: three triangles at vertex 1;     8---14
// 17 positions, of which 3, 8, 1,       /A\B / \      A = (3,1,8)
// 14 and 11 are used.                  3---1 C--11    B = (8,1,14)
//                                                     C = (14,1,11)
//                                        V,E,F = 5,7,3   chi 1   1 loop
Fixture gaps() {
    std::vector<Vec3> positions(17, Vec3{9, 9, 0});
    positions[3] = {0, 0, 0};
    positions[1] = {2, 0, 0};
    positions[8] = {1, 2, 0};
    positions[14] = {3, 2, 0};
    positions[11] = {4, 0, 0};
    return from_loops("gaps", positions, {{3, 1, 8}, {8, 1, 14}, {14, 1, 11}},
                      {{1, 3, 8, 14, 11}});
}

// open_then_closed: triangle (0,1,2), tetrahedron 3..6.
//                                        V,E,F = 7,9,5   chi 3   1 loop
Fixture open_then_closed() {
    std::vector<Loop> faces = {{0, 1, 2}};
    for (const Loop& face : tetra_faces(3)) faces.push_back(face);
    return from_loops("open then closed", joined(triangle_points, tetra_points),
                      faces, {{0, 2, 1}});
}

// closed_then_open: tetrahedron 0..3, triangle (4,5,6).
//                                        V,E,F = 7,9,5   chi 3   1 loop
Fixture closed_then_open() {
    std::vector<Loop> faces = tetra_faces(0);
    faces.push_back({4, 5, 6});
    return from_loops("closed then open", joined(tetra_points, triangle_points),
                      faces, {{4, 6, 5}});
}

// two_tori: vertices 0..6 and 7..13, triangles (i,i+1,i+3) and (i,i+3,i+2)
// modulo 7 in each.                      V,E,F = 14,42,28   chi 0   closed
Fixture two_tori() {
    std::vector<Loop> faces;
    for (const int first : {0, 7})
        for (int i = 0; i < 7; ++i) {
            const auto at = [&](int k) { return first + (i + k) % 7; };
            faces.push_back({at(0), at(1), at(3)});
            faces.push_back({at(0), at(3), at(2)});
        }
    return from_loops("two tori", joined(circle(7, 2, 0), circle(7, 2, 3)),
                      faces, {});
}

// spur: A = (0,1,2,3,0,4) lies on        3-----2
// both sides of the edge 0-4.            |   4 |
//                                        |  /  |
//                                        | / A |
//                                        0-----1
//                                        V,E,F = 5,5,1   chi 1   1 loop
Fixture spur() {
    return from_loops("spur",
                      {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {1, 1, 0}},
                      {{0, 1, 2, 3, 0, 4}}, {{0, 3, 2, 1}});
}

// keyhole: A = (0,1,2,3,0,4,6,5,4) goes    3-------2
// round the triangle B = (4,5,6) and lies  |   6   |
// on both sides of the edge 0-4.           |  /B\  |
//                                          | 4---5 |
//                                          |/    A |
//                                          0-------1
//                                        V,E,F = 7,8,2   chi 1   1 loop
Fixture keyhole() {
    return from_loops("keyhole",
                      {{0, 0, 0},
                       {4, 0, 0},
                       {4, 4, 0},
                       {0, 4, 0},
                       {1, 1, 0},
                       {3, 1, 0},
                       {2, 3, 0}},
                      {{0, 1, 2, 3, 0, 4, 6, 5, 4}, {4, 5, 6}}, {{0, 3, 2, 1}});
}

// pinched_sphere: triangles B = (0,2,1)        2   3
// and C = (0,4,3) on a sphere; all the rest    |\ /|
// of it is A = (0,1,2,0,3,4).                  |B0C|
//                                              |/ \|
//                                              1   4
//                                        V,E,F = 5,6,3   chi 2   closed
Fixture pinched_sphere() {
    return from_loops(
        "pinched sphere",
        {{0, 0, 0}, {-1, -1, 0}, {-1, 1, 0}, {1, 1, 0}, {1, -1, 0}},
        {{0, 1, 2, 0, 3, 4}, {0, 2, 1}, {0, 4, 3}}, {});
}

// loose_edge_after: triangle (0,1,2) and, apart from it, the edge 3-4.
//                                        V,E,F = 5,4,1   chi 2   2 loops
Fixture loose_edge_after() {
    return from_loops("loose edge after",
                      joined(triangle_points, {{3, 0, 0}, {4, 2, 0}}),
                      {{0, 1, 2}}, {{0, 2, 1}, {3, 4}}, {{3, 4}});
}

// loose_edge_before: the edge 0-1 and, apart from it, the quad (2,3,4,5).
//                                        V,E,F = 6,5,1   chi 2   2 loops
Fixture loose_edge_before() {
    return from_loops(
        "loose edge before",
        {{0, 0, 0}, {1, 2, 0}, {2, 0, 0}, {4, 0, 0}, {4, 2, 0}, {2, 2, 0}},
        {{2, 3, 4, 5}}, {{0, 1}, {5, 4, 3, 2}}, {{0, 1}});
}

// loose_chain: triangle (0,1,2) and            2---3---4
// the edges 2-3 and 3-4.                      / \.
//                                            0---1
//                                        V,E,F = 5,5,1   chi 1   1 loop
Fixture loose_chain() {
    return from_loops("loose chain",
                      joined(triangle_points, {{3, 2, 0}, {5, 2, 0}}),
                      {{0, 1, 2}}, {{1, 0, 2, 3, 4, 3, 2}}, {{2, 3}, {3, 4}});
}

// loose_pair: quad (0,1,2,3) and         3---2
// the edges 0-4 and 0-5.                 |   |
//                                    5---0---1
//                                        |
//                                        4
//                                        V,E,F = 6,6,1   chi 1   1 loop
Fixture loose_pair() {
    return from_loops(
        "loose pair",
        {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}, {0, -2, 0}, {-2, 0, 0}},
        {{0, 1, 2, 3}}, {{1, 0, 4, 0, 5, 0, 3, 2}}, {{0, 4}, {0, 5}});
}

// thorn: a ring of three quads between the triangles 0,1,2 (outside) and 3,4,5
// (the hole); the edge 3-6 stands in the hole.
//                                        V,E,F = 7,10,3   chi 0   2 loops
Fixture thorn() {
    return from_loops(
        "thorn",
        joined(joined(circle(3, 3, 0), circle(3, 1.5, 0)), {{0.3, 0, 0}}),
        {{0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}},
        {{0, 2, 1}, {5, 3, 6, 3, 4}}, {{3, 6}});
}

// bridge: triangles (0,1,2) and (3,4,5)      2-------3---5
// and the edge 2-3.                         / \       \ /
//                                          0---1       4
//                                        V,E,F = 6,7,2   chi 1   1 loop
Fixture bridge() {
    return from_loops(
        "bridge", joined(triangle_points, {{4, 2, 0}, {5, 0, 0}, {6, 2, 0}}),
        {{0, 1, 2}, {3, 4, 5}}, {{1, 0, 2, 3, 5, 4, 3, 2}}, {{2, 3}});
}

// pinwheel: triangles (0,1,2), (0,3,4) and (0,5,6) that meet at vertex 0. Its
// three gaps may be linked in several ways, and each is legal.
//                                        V,E,F = 7,9,3   chi 1
namespace {
Fixture pinwheel(std::string name, const std::vector<Loop>& borders) {
    return from_loops(std::move(name), joined({{0, 0, 0}}, circle(6, 2, 0)),
                      {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}}, borders);
}
}  // namespace

// Round vertex 0: 1 2, 5 6, 3 4.         1 loop
Fixture pinwheel_in_turn() {
    return pinwheel("pinwheel in turn", {{1, 0, 4, 3, 0, 6, 5, 0, 2}});
}

// Round vertex 0: 1 2, 3 4, 5 6.         1 loop
Fixture pinwheel_across() {
    return pinwheel("pinwheel across", {{1, 0, 6, 5, 0, 4, 3, 0, 2}});
}

// Round vertex 0: 1 2, 3 4; and apart from them 5 6.         2 loops
Fixture pinwheel_split() {
    return pinwheel("pinwheel split", {{1, 0, 4, 3, 0, 2}, {5, 0, 6}});
}

std::vector<Fixture> all() {
    return {twelve_gon(),
            prism(),
            bipyramid(),
            ring_of_two(),
            ring_closed(),
            gaps(),
            open_then_closed(),
            closed_then_open(),
            two_tori(),
            spur(),
            keyhole(),
            pinched_sphere(),
            loose_edge_after(),
            loose_edge_before(),
            loose_chain(),
            loose_pair(),
            thorn(),
            bridge(),
            pinwheel_in_turn(),
            pinwheel_across(),
            pinwheel_split()};
}

std::vector<Fixture> made_by_hand() {
    std::vector<Fixture> fixtures = zoo::with_table();
    std::ranges::move(all(), std::back_inserter(fixtures));
    return fixtures;
}

std::vector<Fixture> renumbered_copies() {
    std::vector<Fixture> copies;
    for (const Fixture& fixture : made_by_hand())
        copies.push_back(renumbered(fixture, copies.size() + 1));
    return copies;
}

int half_edge(const Fixture& fixture, int from, int to) {
    const std::vector<HalfEdge>& rows = fixture.he.rows();
    const auto found = std::ranges::find_if(rows, [&](const HalfEdge& row) {
        return row.vi == from &&
               rows[static_cast<std::size_t>(row.opp)].vi == to;
    });
    if (found == rows.end())
        throw std::logic_error(fmt::format("{}: no half-edge from {} to {}",
                                           fixture.name, from, to));
    return static_cast<int>(found - rows.begin());
}

}  // namespace course::hidden
