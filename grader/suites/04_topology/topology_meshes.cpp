#include "grader/suites/04_topology/topology_meshes.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

namespace course::hidden {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

std::vector<int> corners_of(FaceList::Face face) {
    return {face.begin(), face.end()};
}

bool is_sound(FaceList::Face face) {
    return face.size() >= 3 &&
           std::set<int>(face.begin(), face.end()).size() == face.size();
}

/// Faces without those in `out`, corners renamed.
FaceList kept(const FaceList& faces, const std::set<int>& out,
              const std::map<int, int>& names) {
    FaceList result;
    for (int f = 0; f < faces.size(); ++f) {
        if (out.contains(f)) continue;
        std::vector<int> corners = corners_of(faces[f]);
        for (int& v : corners)
            if (names.contains(v)) v = names.at(v);
        result.push_back(corners);
    }
    return result;
}

/// The mesh without the vertices that no face uses.
IndexedMesh without_unused(const IndexedMesh& mesh) {
    std::map<int, int> names;
    for (const int v : mesh.faces.corners()) names.emplace(v, 0);
    IndexedMesh result;
    for (auto& [old, name] : names) {
        name = result.vertex_count();
        result.positions.push_back(mesh.positions[at(old)]);
    }
    result.faces = kept(mesh.faces, {}, names);
    return result;
}

constexpr int around = 8, across = 6;  // cells of each torus

/// The face of the torus in that cell.
int cell(int i, int j) {
    return i * across + j;
}

IndexedMesh far_away(IndexedMesh mesh, double x) {
    for (Vec3& p : mesh.positions) p = p + Vec3{x, 0, 0};
    return mesh;
}

}  // namespace

Fixture with_table_built(std::string name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

Fixture face_list_only(std::string name, IndexedMesh mesh) {
    return {std::move(name), std::move(mesh), {}};
}

IndexedMesh side_by_side(const std::vector<IndexedMesh>& parts) {
    IndexedMesh all;
    for (const IndexedMesh& part : parts) {
        const int first = all.vertex_count();
        for (const Vec3& p : part.positions)
            all.positions.push_back(p + Vec3{0, 0, 0.1 * first});
        for (const FaceList::Face face : part.faces) {
            std::vector<int> corners = corners_of(face);
            for (int& v : corners) v += first;
            all.faces.push_back(corners);
        }
        for (const auto& edge : part.loose_edges)
            all.loose_edges.push_back({edge[0] + first, edge[1] + first});
    }
    return all;
}

// A torus is a grid of cells, glued left to right and bottom to top. The cells
// marked a and b are taken out where two tori meet, those marked o are holes:
//     . . . . . . . .
//     . . . . . . . .
//     . . . . b . . .
//     . . . . . . . .
//     . o . o . o . o
//     a . . . . . . .
IndexedMesh surface_of_genus(int genus, int holes) {
    std::vector<IndexedMesh> tori;
    for (int k = 0; k < genus; ++k)
        tori.push_back(far_away(torus(around, across), 7.0 * k));
    IndexedMesh mesh = genus == 0 ? icosphere(2) : side_by_side(tori);

    std::set<int> out;
    std::map<int, int> names;
    for (int k = 0; k + 1 < genus; ++k) {
        const int b = k * around * across + cell(4, 3);
        const int a = (k + 1) * around * across + cell(0, 0);
        out.insert({a, b});
        for (int c = 0; c < 4; ++c)
            names[mesh.faces[a][at(c)]] = mesh.faces[b][at(3 - c)];
    }
    const std::array<int, 4> of_torus = {cell(1, 1), cell(3, 1), cell(5, 1),
                                         cell(7, 1)};
    const std::array<int, 4> of_sphere = {0, 80, 160, 240};
    for (int k = 0; k < holes; ++k)
        out.insert(genus == 0 ? of_sphere[at(k)] : of_torus[at(k)]);
    mesh.faces = kept(mesh.faces, out, names);
    return without_unused(mesh);
}

namespace {

/// Vertices 2i and 2i + 1 are the two ends of rung i; the last quad ends at
/// the rung (left, right).
IndexedMesh band(int quads, int left, int right) {
    IndexedMesh mesh;
    for (int i = 0; i < quads; ++i)
        for (const double z : {0.0, 1.0}) {
            const double angle = 6.283185307179586 * i / quads;
            mesh.positions.push_back(
                {3 * std::cos(angle), 3 * std::sin(angle), z});
        }
    for (int i = 0; i + 1 < quads; ++i)
        mesh.faces.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    mesh.faces.push_back({2 * quads - 2, left, right, 2 * quads - 1});
    return mesh;
}

}  // namespace

IndexedMesh straight_band(int quads) {
    return band(quads, 0, 1);
}

IndexedMesh twisted_band(int quads) {
    return band(quads, 1, 0);
}

IndexedMesh triangle_strip(int triangles) {
    IndexedMesh mesh;
    for (int v = 0; v < triangles + 2; ++v)
        mesh.positions.push_back({0.5 * v, v % 2 == 0 ? 0.0 : 1.0, 0});
    for (int f = 0; f < triangles; ++f)
        mesh.faces.push_back({f, f + 1 + f % 2, f + 2 - f % 2});
    return mesh;
}

// checkered_octahedron: a ring 0..3, apex 4 above it and apex 5 below it. Four
// triangles meet only at their corners; the half-edges of the other four keep
// their `next`, so that each is a loop.      V,E,F = 6,12,4   chi -2   4 loops
Fixture checkered_octahedron() {
    const std::vector<Vec3> positions = {{1, 0, 0},  {0, 1, 0}, {-1, 0, 0},
                                         {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const FaceList kept_faces = {{0, 1, 4}, {2, 3, 4}, {2, 1, 5}, {0, 3, 5}};
    IndexedMesh closed{positions, kept_faces, {}};
    closed.faces.push_back({1, 2, 4});
    closed.faces.push_back({3, 0, 4});
    closed.faces.push_back({1, 0, 5});
    closed.faces.push_back({3, 2, 5});
    std::vector<HalfEdge> rows = build(closed).rows();
    for (HalfEdge& row : rows)
        if (row.fi >= kept_faces.size()) row.fi = -1;
    return {"checkered octahedron",
            {positions, kept_faces, {}},
            HalfEdgeTable(std::move(rows))};
}

Fixture flipped(const Fixture& fixture, const std::vector<int>& faces) {
    const std::set<int> turned(faces.begin(), faces.end());
    Fixture result = {fixture.name + ", faces turned over", fixture.mesh, {}};
    result.mesh.faces = {};
    for (int f = 0; f < fixture.mesh.faces.size(); ++f) {
        std::vector<int> corners = corners_of(fixture.mesh.faces[f]);
        if (turned.contains(f)) std::reverse(corners.begin(), corners.end());
        result.mesh.faces.push_back(corners);
    }
    return result;
}

std::vector<int> any_order(int n, std::uint64_t salt) {
    std::uint64_t state = seed() * 1000 + salt;
    std::vector<std::pair<std::uint64_t, int>> drawn;
    for (int k = 0; k < n; ++k) {
        state = state * 6364136223846793005U + 1442695040888963407U;
        drawn.push_back({(state ^ (state >> 29)) * 0x9E3779B97F4A7C15U, k});
    }
    std::sort(drawn.begin(), drawn.end());
    std::vector<int> order;
    for (const auto& [value, k] : drawn) order.push_back(k);
    return order;
}

Fixture shuffled(const Fixture& fixture, std::uint64_t salt) {
    const IndexedMesh& mesh = fixture.mesh;
    const int more = 2;  // vertices that nothing uses
    const std::vector<int> name = any_order(mesh.vertex_count() + more, salt);
    Fixture result = {fixture.name + " (shuffled)", {}, {}};
    result.mesh.positions.resize(name.size());
    for (int v = 0; v < mesh.vertex_count(); ++v)
        result.mesh.positions[at(name[at(v)])] = mesh.positions[at(v)];
    for (const int f : any_order(mesh.faces.size(), salt + 500)) {
        std::vector<int> corners;
        for (const int v : mesh.faces[f]) corners.push_back(name[at(v)]);
        const auto first = corners.begin() + (f + static_cast<int>(salt % 7)) %
                                                 std::ssize(corners);
        std::rotate(corners.begin(), first, corners.end());
        result.mesh.faces.push_back(corners);
    }
    for (const auto& edge : mesh.loose_edges)
        result.mesh.loose_edges.push_back(
            {name[at(edge[0])], name[at(edge[1])]});
    return result;
}

Fixture merged(const Fixture& fixture, int from, int to) {
    Fixture result = fixture;
    result.name += ", two vertices merged";
    result.he = {};
    result.mesh.faces = kept(fixture.mesh.faces, {}, {{from, to}});
    return sound_faces(result);
}

Fixture sound_faces(const Fixture& fixture) {
    Fixture result = {fixture.name, fixture.mesh, {}};
    result.mesh.faces = {};
    result.mesh.loose_edges.clear();
    for (const FaceList::Face face : fixture.mesh.faces)
        if (is_sound(face)) result.mesh.faces.push_back(face);
    return result;
}

std::vector<Fixture> all_face_lists() {
    std::vector<Fixture> all = made_by_hand();
    for (const auto& make : {zoo::moebius3q, zoo::moebius5, zoo::klein4x4,
                             zoo::rp2_6, zoo::fan3, zoo::house_with_wall})
        all.push_back(make());
    for (Fixture& fixture : all) fixture = sound_faces(fixture);
    return all;
}

HalfEdgeTable with_gaps(const HalfEdgeTable& he) {
    std::vector<HalfEdge> rows = he.rows();
    for (HalfEdge& row : rows) {
        row.vi = 7 * row.vi + 5;
        if (row.fi >= 0) row.fi = 9 * row.fi + 4;
    }
    return HalfEdgeTable(std::move(rows));
}

}  // namespace course::hidden
