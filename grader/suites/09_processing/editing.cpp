#include "grader/suites/09_processing/editing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

namespace course::editing {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

/// Calls f(from, to) for each side of the loop.
template <class F>
void for_each_side(const Loop& loop, F f) {
    for (std::size_t k = 0; k < loop.size(); ++k)
        f(loop[k], loop[(k + 1) % loop.size()]);
}

bool comes_once(Loop loop) {
    std::sort(loop.begin(), loop.end());
    return std::adjacent_find(loop.begin(), loop.end()) == loop.end();
}

/// The loop with b for a, and no corner that follows itself.
Loop with_b_for_a(Loop loop, int a, int b) {
    std::replace(loop.begin(), loop.end(), a, b);
    loop.erase(std::unique(loop.begin(), loop.end()), loop.end());
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
}

std::set<int> vertices_of(const Content& content) {
    std::set<int> used;
    for (const auto& [f, loop] : content.faces)
        used.insert(loop.begin(), loop.end());
    return used;
}

using Sides = std::multiset<std::pair<int, int>>;

Sides sides_of_faces(const Content& content) {
    Sides sides;
    for (const auto& [f, loop] : content.faces)
        for_each_side(loop, [&](int u, int v) { sides.emplace(u, v); });
    return sides;
}

/// Each edge has exactly two sides, back and forth, and not both on a border.
bool edges_are_sound(const Content& content) {
    const Sides with_face = sides_of_faces(content);
    Sides all = with_face;
    for (const Loop& border : content.borders)
        for_each_side(border, [&](int u, int v) { all.emplace(u, v); });
    return std::all_of(all.begin(), all.end(), [&](const auto& side) {
        const std::pair back(side.second, side.first);
        return side != back && all.count(side) == 1 && all.count(back) == 1 &&
               (with_face.count(side) == 1 || with_face.count(back) == 1);
    });
}

bool loops_are_sound(const Content& content) {
    Loop on_borders;
    for (const Loop& border : content.borders)
        on_borders.insert(on_borders.end(), border.begin(), border.end());
    return comes_once(on_borders) &&
           std::all_of(
               content.faces.begin(), content.faces.end(),
               [](const auto& entry) { return comes_once(entry.second); });
}

bool has_edges_enough(const Content& content, int v) {
    std::set<int> neighbours;
    for (const auto& [from, to] : sides_of_faces(content)) {
        if (from == v) neighbours.insert(to);
        if (to == v) neighbours.insert(from);
    }
    const bool on_border = std::any_of(
        content.borders.begin(), content.borders.end(), [&](const Loop& loop) {
            return std::find(loop.begin(), loop.end(), v) != loop.end();
        });
    return neighbours.size() >= (on_border ? 2U : 3U);
}

std::string show_loop(const Loop& loop) {
    return fmt::format("({})", fmt::join(loop, ","));
}

std::vector<Vec3> circle(int n, double radius, double z) {
    std::vector<Vec3> points;
    for (int k = 0; k < n; ++k) {
        const double angle = 2 * std::numbers::pi * k / n;
        points.push_back(
            {radius * std::cos(angle), radius * std::sin(angle), z});
    }
    return points;
}

/// Triangles between the ring a..a+n-1 below and b..b+n-1 above.
void add_band(FaceList& faces, int a, int b, int n) {
    for (int k = 0; k < n; ++k) {
        const int after = (k + 1) % n;
        faces.push_back({a + k, a + after, b + k});
        faces.push_back({a + after, b + after, b + k});
    }
}

}  // namespace

Loop from_smallest(Loop loop) {
    Loop least = loop;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        least = std::min(least, loop);
    }
    return least;
}

Content in_order(Content content) {
    for (auto& [f, loop] : content.faces) loop = from_smallest(loop);
    for (Loop& loop : content.borders) loop = from_smallest(loop);
    std::sort(content.borders.begin(), content.borders.end());
    return content;
}

Content content_of(const HalfEdgeTable& he) {
    const std::vector<HalfEdge>& rows = he.rows();
    std::vector<char> done(rows.size(), 0);
    Content content;
    for (int start = 0; start < he.size(); ++start) {
        Loop loop;
        for (int i = start; done[at(i)] == 0; i = rows[at(i)].next) {
            done[at(i)] = 1;
            loop.push_back(rows[at(i)].vi);
        }
        if (loop.empty()) continue;
        const int f = rows[at(start)].fi;
        if (f == -1)
            content.borders.push_back(loop);
        else
            content.faces[f] = loop;
    }
    return in_order(std::move(content));
}

std::string broken_rule(const HalfEdgeTable& he) {
    const std::vector<Finding> findings = validate(he);
    return findings.empty() ? "" : to_string(he, findings.front());
}

std::string difference(const HalfEdgeTable& got, const Content& expected) {
    return difference(got, expected, {});
}

namespace {

/// The first face that is not as expected, or "".
std::string face_difference(const std::map<int, Loop>& got,
                            const std::map<int, Loop>& expected,
                            std::vector<Loop> new_faces) {
    for (Loop& loop : new_faces) loop = from_smallest(loop);
    for (const auto& [f, loop] : got) {
        const auto found = expected.find(f);
        if (found != expected.end() && found->second != loop)
            return fmt::format("face {} is {}, expected {}", f, show_loop(loop),
                               show_loop(found->second));
        if (found == expected.end() && std::erase(new_faces, loop) != 1)
            return fmt::format("there is a face {}, {}, expected none", f,
                               show_loop(loop));
    }
    for (const auto& [f, loop] : expected)
        if (!got.contains(f))
            return fmt::format("face {} is missing, expected {}", f,
                               show_loop(loop));
    if (new_faces.empty()) return "";
    return fmt::format("there is no face {}", show_loop(new_faces.front()));
}

std::string show_loops(const std::vector<Loop>& loops) {
    std::vector<std::string> shown;
    for (const Loop& loop : loops) shown.push_back(show_loop(loop));
    return fmt::format("{}", fmt::join(shown, " "));
}

}  // namespace

std::string difference(const HalfEdgeTable& table, const Content& expected,
                       std::vector<Loop> new_faces) {
    const std::string rule = broken_rule(table);
    if (!rule.empty()) return rule;
    const Content got = content_of(table);
    const std::string face =
        face_difference(got.faces, expected.faces, std::move(new_faces));
    if (!face.empty() || got.borders == expected.borders) return face;
    return fmt::format("the borders are {}, expected {}",
                       show_loops(got.borders), show_loops(expected.borders));
}

ContentMatcher Says(Content expected, std::vector<Loop> new_faces) {
    return {std::move(expected), std::move(new_faces)};
}

std::pair<int, int> ends(const HalfEdgeTable& he, int i) {
    const HalfEdge& row = he.rows()[at(i)];
    return {row.vi, he.rows()[at(row.opp)].vi};
}

Content pulled_together(const Content& content, int a, int b) {
    Content result;
    for (const auto& [f, loop] : content.faces) {
        const Loop shorter = with_b_for_a(loop, a, b);
        if (shorter.size() >= 3) result.faces[f] = shorter;
    }
    for (const Loop& loop : content.borders)
        result.borders.push_back(with_b_for_a(loop, a, b));
    return in_order(std::move(result));
}

bool may_be_pulled_together(const Content& content, int a, int b) {
    const Content after = pulled_together(content, a, b);
    std::set<int> expected = vertices_of(content);
    expected.erase(a);
    return edges_are_sound(after) && loops_are_sound(after) &&
           has_edges_enough(after, b) && vertices_of(after) == expected;
}

bool is_surface(const Fixture& fixture) {
    const Content content = content_of(fixture.he);
    return bow_tie_vertices(fixture.mesh).empty() && edges_are_sound(content) &&
           loops_are_sound(content);
}

Fixture made(std::string name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

// octahedron: a ring 0..3, apex 4 above it and apex 5 below it.
//                                        V,E,F = 6,12,8   chi 2   closed
Fixture octahedron() {
    IndexedMesh mesh{circle(4, 2, 0), {}, {}};
    mesh.positions.push_back({0, 0, 2});
    mesh.positions.push_back({0, 0, -2});
    for (int k = 0; k < 4; ++k) {
        mesh.faces.push_back({k, (k + 1) % 4, 4});
        mesh.faces.push_back({(k + 1) % 4, k, 5});
    }
    return made("octahedron", mesh);
}

// three_peaks: a ring 0..2, apex 3 above it and apex 4 below it. The edges of
// the ring have a third common neighbour.
//                                        V,E,F = 5,9,6   chi 2   closed
Fixture three_peaks() {
    IndexedMesh mesh{circle(3, 2, 0), {}, {}};
    mesh.positions.push_back({0, 0, 2});
    mesh.positions.push_back({0, 0, -2});
    for (int k = 0; k < 3; ++k) {
        mesh.faces.push_back({k, (k + 1) % 3, 3});
        mesh.faces.push_back({(k + 1) % 3, k, 4});
    }
    return made("three peaks", mesh);
}

// hexagon_lid: the hexagon (0,...,5) on a bowl. In the bowl runs the edge 0-3,
// between the corners 6 and 7. Its ends have no other common neighbour, but
// both are corners of the hexagon.
//                                        V,E,F = 8,15,9   chi 2   closed
Fixture hexagon_lid() {
    IndexedMesh mesh{circle(6, 2, 0), {}, {}};
    mesh.positions.push_back({0.2, 1, -1});
    mesh.positions.push_back({-0.2, -1, -1});
    mesh.faces = {{0, 1, 2, 3, 4, 5}, {0, 3, 6}, {3, 2, 6},
                  {2, 1, 6},          {1, 0, 6}, {0, 5, 7},
                  {5, 4, 7},          {4, 3, 7}, {3, 0, 7}};
    return made("hexagon lid", mesh);
}

// cut_square: (0,1,2) and (0,2,3).       V,E,F = 4,5,2   chi 1   1 loop
Fixture cut_square() {
    return made("cut square", {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                               {{0, 1, 2}, {0, 2, 3}},
                               {}});
}

// tube_of_three: rings 0..2 below and 3..5 above, six triangles between them.
//                                        V,E,F = 6,12,6   chi 0   2 loops
Fixture tube_of_three() {
    IndexedMesh mesh{circle(3, 2, -1), {}, {}};
    for (const Vec3& p : circle(3, 1, 1)) mesh.positions.push_back(p);
    add_band(mesh.faces, 0, 3, 3);
    return made("tube of three", mesh);
}

// neck: rings 0..5, 6..8 and 9..14, apex 15 below the first and 16 above the
// last. Between rings of six and three, two edges of the larger one share a
// vertex of the smaller one.
//                                        V,E,F = 17,45,30   chi 2   closed
Fixture neck() {
    IndexedMesh mesh{circle(6, 3, -2), {}, {}};
    for (const Vec3& p : circle(3, 1, 0)) mesh.positions.push_back(p);
    for (const Vec3& p : circle(6, 3, 2)) mesh.positions.push_back(p);
    mesh.positions.push_back({0, 0, -3});
    mesh.positions.push_back({0, 0, 3});
    for (int k = 0; k < 3; ++k) {
        const int a = 2 * k, b = 2 * k + 1, c = (2 * k + 2) % 6;
        const int mid = 6 + k, after = 6 + (k + 1) % 3;
        mesh.faces.push_back({a, b, mid});
        mesh.faces.push_back({b, after, mid});
        mesh.faces.push_back({b, c, after});
        mesh.faces.push_back({9 + b, 9 + a, mid});
        mesh.faces.push_back({9 + b, mid, after});
        mesh.faces.push_back({9 + c, 9 + b, after});
    }
    for (int k = 0; k < 6; ++k) {
        mesh.faces.push_back({(k + 1) % 6, k, 15});
        mesh.faces.push_back({9 + k, 9 + (k + 1) % 6, 16});
    }
    return made("neck", mesh);
}

// ribbon: 1-3-5-7 above 0-2-4-6, cut into six triangles.
//                                        V,E,F = 8,13,6   chi 1   1 loop
Fixture ribbon() {
    IndexedMesh mesh;
    for (int k = 0; k < 8; ++k)
        mesh.positions.push_back({double(k / 2), double(k % 2), 0});
    for (int k = 0; k < 6; k += 2) {
        mesh.faces.push_back({k, k + 2, k + 1});
        mesh.faces.push_back({k + 1, k + 2, k + 3});
    }
    return made("ribbon", mesh);
}

// one_quad: (0,1,2,3).                   V,E,F = 4,4,1   chi 1   1 loop
Fixture one_quad() {
    return made(
        "one quad",
        {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, {{0, 1, 2, 3}}, {}});
}

// open_tetra: the triangles of a tetrahedron at its apex 3.
//                                        V,E,F = 4,6,3   chi 1   1 loop
Fixture open_tetra() {
    IndexedMesh mesh{circle(3, 2, 0), {}, {}};
    mesh.positions.push_back({0, 0, 2});
    mesh.faces = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    return made("open tetra", mesh);
}

// ear: the triangle (0,4,1) stands on      3---------2
// the edge 0-1 of the face (0,4,1,2,3)     |    A    |
// with the tip 4 inside, which has two     |   4     |
// edges only.                              |  / \    |
//                                          | / B \   |
//                                          0---------1
//                                        V,E,F = 5,6,2   chi 1   1 loop
Fixture ear() {
    return made("ear", {{{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}, {2, 2, 0}},
                        {{0, 4, 1, 2, 3}, {0, 1, 4}},
                        {}});
}

std::vector<Fixture> surfaces() {
    std::vector<Fixture> fixtures = {
        octahedron(), three_peaks(),   hexagon_lid(),
        cut_square(), tube_of_three(), neck(),
        ribbon(),     one_quad(),      ear()};
    for (const Fixture& fixture : hidden::made_by_hand())
        if (is_surface(fixture)) fixtures.push_back(fixture);
    return fixtures;
}

std::vector<Fixture> renumbered_surfaces() {
    std::vector<Fixture> copies;
    for (const Fixture& fixture : surfaces())
        copies.push_back(renumbered(fixture, copies.size() + 1));
    return copies;
}

std::vector<Fixture> generated_surfaces() {
    std::vector<Fixture> all;
    constexpr Surface kinds[] = {Surface::open, Surface::closed,
                                 Surface::mixed};
    for (std::uint64_t k = 0; k < 6; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k) / 2;
        options.merge_percent = k % 2 == 0 ? 0 : 40;
        options.surface = kinds[k % 3];
        Fixture fixture = made("generated mesh " + std::to_string(k),
                               random_polygons(seed() * 100 + 50 + k, options));
        if (is_surface(fixture)) all.push_back(renumbered(fixture, k));
    }
    return all;
}

Fixture with_gaps_in_faces(Fixture fixture) {
    std::vector<HalfEdge> rows = fixture.he.rows();
    for (HalfEdge& row : rows)
        if (row.fi != -1) row.fi = 3 * row.fi + 2;
    fixture.he = HalfEdgeTable(std::move(rows));
    fixture.name += ", gaps in the numbers of its faces";
    return fixture;
}

std::vector<Fixture> of_triangles(std::vector<Fixture> fixtures) {
    std::erase_if(fixtures, [](const Fixture& fixture) {
        return std::any_of(fixture.mesh.faces.begin(), fixture.mesh.faces.end(),
                           [](FaceList::Face f) { return f.size() != 3; });
    });
    return fixtures;
}

}  // namespace course::editing
