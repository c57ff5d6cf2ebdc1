// Building the table, all its defects, and the way back, against oracles that
// look at nothing but the faces.
#include "course/halfedge/build.h"

#include <algorithm>
#include <array>
#include <climits>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "course/halfedge/validate.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"
#include "course/tests/mesh_counts.h"

namespace course {

namespace {

using brute::at;
using brute::rotated_faces;

IndexedMesh mesh_of(int vertices, FaceList faces,
                    std::vector<std::array<int, 2>> loose = {}) {
    return {std::vector<Vec3>(at(vertices)), std::move(faces),
            std::move(loose)};
}

std::vector<std::string> lines_of(const IndexedMesh& mesh) {
    std::vector<std::string> lines;
    for (const Defect& defect : defects(mesh))
        lines.push_back(to_string(defect));
    return lines;
}

using Lines = std::vector<std::string>;

std::set<std::pair<int, int>> edges_of(
    const std::vector<std::array<int, 2>>& edges) {
    std::set<std::pair<int, int>> sorted;
    for (const auto& [a, b] : edges)
        sorted.insert({std::min(a, b), std::max(a, b)});
    return sorted;
}

/// Half-edges met by the walk of opp and next from i.
std::set<int> star(const HalfEdgeTable& he, int i) {
    std::set<int> met;
    while (met.insert(i).second) i = he[he[i].opp].next;
    return met;
}

// ---- defects by brute force: every pair of corners is compared

bool is_flawed(const IndexedMesh& mesh, int f) {
    const auto face = mesh.faces[f];
    if (face.size() < 3) return true;
    const std::set<int> distinct(face.begin(), face.end());
    return distinct.size() != face.size() || *distinct.begin() < 0 ||
           *distinct.rbegin() >= mesh.vertex_count();
}

int times(FaceList::Face face, int from, int to) {
    int n = 0;
    for (std::size_t k = 0; k < face.size(); ++k)
        if (face[k] == from && face[(k + 1) % face.size()] == to) ++n;
    return n;
}

using Key = std::tuple<DefectKind, std::vector<int>, std::vector<int>,
                       std::vector<int>, int, int>;

Key key_of(const Defect& d) {
    return {d.kind, d.faces, d.vertices, d.loose_edges, d.corner, d.count};
}

void face_keys(const IndexedMesh& mesh, int f, std::set<Key>& keys) {
    const auto face = mesh.faces[f];
    const int n = static_cast<int>(face.size());
    if (n < 3) keys.insert({DefectKind::too_few_corners, {f}, {}, {}, -1, n});
    for (int k = 0; k < n; ++k)
        if (face[at(k)] < 0 || face[at(k)] >= mesh.vertex_count())
            keys.insert({DefectKind::index_out_of_range,
                         {f},
                         {face[at(k)]},
                         {},
                         k,
                         mesh.vertex_count()});
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < k; ++j)
            if (face[at(j)] == face[at(k)])
                keys.insert({DefectKind::repeated_vertex,
                             {f},
                             {face[at(k)]},
                             {},
                             -1,
                             -1});
}

void edge_keys(const IndexedMesh& mesh, int low, int high,
               std::set<Key>& keys) {
    std::vector<int> faces;
    int rising = 0;
    bool first_rises = false;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        if (is_flawed(mesh, f)) continue;
        const int up = times(mesh.faces[f], low, high);
        if (up + times(mesh.faces[f], high, low) == 0) continue;
        if (faces.empty()) first_rises = up == 1;
        faces.push_back(f);
        rising += up;
    }
    const std::vector<int> ends =
        first_rises ? std::vector{low, high} : std::vector{high, low};
    if (faces.size() > 2)
        keys.insert(
            {DefectKind::edge_with_many_faces, faces, ends, {}, -1, -1});
    if (faces.size() == 2 && rising != 1)
        keys.insert({DefectKind::faces_wound_alike, faces, ends, {}, -1, -1});
    for (int e = 0; at(e) < mesh.loose_edges.size(); ++e) {
        const auto [a, b] = mesh.loose_edges[at(e)];
        if (std::minmax(a, b) != std::minmax(low, high)) continue;
        int first = 0;
        while (std::minmax(mesh.loose_edges[at(first)][0],
                           mesh.loose_edges[at(first)][1]) !=
               std::minmax(low, high))
            ++first;
        if (first == e && faces.empty()) continue;
        keys.insert({DefectKind::loose_edge_repeated,
                     faces,
                     {a, b},
                     first == e ? std::vector{e} : std::vector{e, first},
                     -1,
                     -1});
    }
}

void duplicate_keys(const IndexedMesh& mesh, std::set<Key>& keys) {
    const auto rotated = rotated_faces(mesh.faces);
    for (int f = 0; f < mesh.faces.size(); ++f) {
        if (is_flawed(mesh, f)) continue;
        std::vector<int> same;
        for (int g = 0; g < mesh.faces.size(); ++g)
            if (rotated[at(g)] == rotated[at(f)]) same.push_back(g);
        if (same.size() > 1)
            keys.insert(
                {DefectKind::duplicate_face, same, rotated[at(f)], {}, -1, -1});
    }
}

std::set<Key> all_keys(const IndexedMesh& mesh) {
    std::set<Key> keys;
    const int n = mesh.vertex_count();
    for (int f = 0; f < mesh.faces.size(); ++f) face_keys(mesh, f, keys);
    for (int low = 0; low < n; ++low)
        for (int high = low + 1; high < n; ++high)
            edge_keys(mesh, low, high, keys);
    duplicate_keys(mesh, keys);
    for (int e = 0; at(e) < mesh.loose_edges.size(); ++e) {
        const auto [a, b] = mesh.loose_edges[at(e)];
        for (int end = 0; end < 2; ++end) {
            const int v = mesh.loose_edges[at(e)][at(end)];
            if (v < 0 || v >= n)
                keys.insert({DefectKind::loose_edge_out_of_range,
                             {},
                             {v},
                             {e},
                             end,
                             n});
        }
        if (a == b)
            keys.insert(
                {DefectKind::loose_edge_equal_ends, {}, {a}, {e}, -1, -1});
    }
    return keys;
}

// ---- fans by brute force: faces at v, joined when they share an edge there

int fans_at(const IndexedMesh& mesh, int v) {
    std::vector<std::set<int>> fans;  // the neighbours of v in each
    for (const auto face : mesh.faces) {
        const auto here = std::find(face.begin(), face.end(), v);
        if (here == face.end()) continue;
        const auto k = static_cast<std::size_t>(here - face.begin());
        std::set<int> joined = {face[(k + 1) % face.size()],
                                face[(k + face.size() - 1) % face.size()]};
        std::vector<std::set<int>> others;
        for (const auto& fan : fans) {
            const bool meets =
                std::any_of(joined.begin(), joined.end(),
                            [&](int u) { return fan.count(u) > 0; });
            if (meets)
                joined.insert(fan.begin(), fan.end());
            else
                others.push_back(fan);
        }
        others.push_back(joined);
        fans = others;
    }
    return static_cast<int>(fans.size());
}

/// How many closed fans vertex v has, whose stars no border passes through.
int closed_fans_at(const HalfEdgeTable& he, int v) {
    std::set<int> seen;
    int closed = 0;
    for (int i = 0; i < he.size(); ++i) {
        if (he[i].vi != v || seen.count(i) > 0) continue;
        const std::set<int> met = star(he, i);
        seen.insert(met.begin(), met.end());
        closed += std::none_of(met.begin(), met.end(),
                               [&](int k) { return he[k].fi == -1; });
    }
    return closed;
}

}  // namespace

TEST_CASE("the mesh of the slides gives a table with one border loop") {
    const IndexedMesh mesh = mesh_of(6, {{0, 2, 1}, {1, 2, 5, 4}, {2, 3, 5}});
    const HalfEdgeTable he = build(mesh);
    CHECK(he.size() == 16);
    CHECK(validate(he).empty());
    CHECK(rotated_faces(to_faces(he)) == rotated_faces(mesh.faces));
    // The border runs 2-0-1-4-5-3, against the sense of the faces.
    int i = 0;
    while (he[i].fi != -1 || he[i].vi != 2) ++i;
    std::vector<int> border;
    for (int k = 0; k < 6; ++k, i = he[i].next) border.push_back(he[i].vi);
    CHECK(border == std::vector{2, 0, 1, 4, 5, 3});
}

TEST_CASE("opposite half-edges are made side by side") {
    const HalfEdgeTable he =
        build(mesh_of(4, {{0, 1, 2}, {0, 2, 3}}, {{1, 3}}));
    for (int i = 0; i < he.size(); ++i)
        CHECK(he[i].opp == (i % 2 == 0 ? i + 1 : i - 1));
}

TEST_CASE("an empty mesh has an empty table") {
    CHECK(build({}).empty());
    CHECK(build(mesh_of(3, {})).empty());
    CHECK(to_faces({}).empty());
    CHECK(loose_edges({}).empty());
}

TEST_CASE("a closed mesh has no border half-edges") {
    const HalfEdgeTable he =
        build(mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}));
    CHECK(he.size() == 12);
    CHECK(validate(he).empty());
    for (int i = 0; i < he.size(); ++i) CHECK(he[i].fi != -1);
}

TEST_CASE("bow-tie vertices are legal, and one walk meets all their borders") {
    // Three triangles that share vertex 0 and nothing else.
    const IndexedMesh mesh = mesh_of(7, {{0, 1, 2}, {0, 3, 4}, {0, 5, 6}});
    const HalfEdgeTable he = build(mesh);
    CHECK(validate(he).empty());
    CHECK(bow_tie_vertices(mesh) == std::vector{0});
    for (int i = 0; i < he.size(); ++i)
        if (he[i].vi == 0) CHECK(star(he, i).size() == 6);
}

TEST_CASE("two closed surfaces at one vertex are legal") {
    // hourglass: two tetrahedra, 0 1 2 3 and 0 4 5 6
    const IndexedMesh mesh = mesh_of(7, {{0, 1, 2},
                                         {0, 2, 3},
                                         {0, 3, 1},
                                         {1, 3, 2},
                                         {0, 4, 5},
                                         {0, 5, 6},
                                         {0, 6, 4},
                                         {4, 6, 5}});
    CHECK(validate(build(mesh)).empty());
    CHECK(bow_tie_vertices(mesh) == std::vector{0});
}

TEST_CASE("a loose edge lies on the border of the face it hangs from") {
    const HalfEdgeTable he = build(mesh_of(4, {{0, 1, 2}}, {{2, 3}}));
    CHECK(validate(he).empty());
    CHECK(loose_edges(he) == std::vector<std::array<int, 2>>{{2, 3}});
    int i = he[0].opp;
    std::vector<int> border;
    for (int k = 0; k < 5; ++k, i = he[i].next) border.push_back(he[i].vi);
    CHECK(i == he[0].opp);
    CHECK(border == std::vector{1, 0, 2, 3, 2});
}

TEST_CASE("loose edges alone make components, and chains and stars of them") {
    const HalfEdgeTable one = build(mesh_of(2, {}, {{1, 0}}));
    CHECK(one == HalfEdgeTable{{1, -1, 1, 1}, {0, -1, 0, 0}});
    const HalfEdgeTable tree =
        build(mesh_of(6, {}, {{0, 1}, {1, 2}, {3, 1}, {4, 5}}));
    CHECK(validate(tree).empty());
    CHECK(star(tree, 1).size() == 3);  // half-edge 1 leaves vertex 1
    CHECK(loose_edges(tree) ==
          std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {3, 1}, {4, 5}});
}

TEST_CASE("a loose edge may stand on an interior vertex") {
    const HalfEdgeTable he = build(
        mesh_of(5, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}, {{0, 4}}));
    CHECK(validate(he).empty());
    CHECK(loose_edges(he).size() == 1);
}

TEST_CASE("each kind of defect is told with its elements") {
    CHECK(lines_of(mesh_of(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}})) ==
          Lines{"edge 0-1 has 3 faces, 0, 1 and 2, but an edge has at most 2"});
    CHECK(lines_of(mesh_of(4, {{0, 1, 2}, {0, 1, 3}})) ==
          Lines{"edge 0-1: faces 0 and 1 both run from 0 to 1, but two faces "
                "run along their edge in opposite directions"});
    CHECK(lines_of(mesh_of(4, {{1, 0, 2}, {1, 0, 3}})) ==
          Lines{"edge 1-0: faces 0 and 1 both run from 1 to 0, but two faces "
                "run along their edge in opposite directions"});
    CHECK(lines_of(mesh_of(3, {{0, 1, 2, 1}})) ==
          Lines{"face 0 names vertex 1 more than once, but the corners of a "
                "face differ"});
    CHECK(lines_of(mesh_of(3, {{0, 1}, {2}, {}})) ==
          Lines{"face 0 has 2 corners, but a face has at least 3",
                "face 1 has 1 corner, but a face has at least 3",
                "face 2 has 0 corners, but a face has at least 3"});
    CHECK(lines_of(mesh_of(3, {{0, 1, 3}, {-1, 1, 2}})) ==
          Lines{"face 0, corner 2: the vertex is 3, but the mesh has 3 "
                "vertices, numbered from 0",
                "face 1, corner 0: the vertex is -1, but the mesh has 3 "
                "vertices, numbered from 0"});
}

TEST_CASE("a duplicate face is told with the edges that it spoils") {
    CHECK(lines_of(mesh_of(3, {{0, 1, 2}, {1, 2, 0}})) ==
          Lines{"edge 0-1: faces 0 and 1 both run from 0 to 1, but two faces "
                "run along their edge in opposite directions",
                "edge 2-0: faces 0 and 1 both run from 2 to 0, but two faces "
                "run along their edge in opposite directions",
                "edge 1-2: faces 0 and 1 both run from 1 to 2, but two faces "
                "run along their edge in opposite directions",
                "faces 0 and 1 are the same face, with the vertices 0, 1, 2; a "
                "face comes once"});
}

TEST_CASE("a face and its mirror image are two faces") {
    CHECK(defects(mesh_of(3, {{0, 1, 2}, {0, 2, 1}})).empty());
}

TEST_CASE("each defect of a loose edge is told with its number") {
    CHECK(lines_of(mesh_of(4, {{0, 1, 2}},
                           {{0, 3}, {4, 0}, {3, 3}, {3, 0}, {1, 0}})) ==
          Lines{"loose edge 1, end 0: the vertex is 4, but the mesh has 4 "
                "vertices, "
                "numbered from 0",
                "loose edge 2 joins vertex 3 to itself, but an edge has two "
                "ends",
                "loose edge 3 joins vertices 3 and 0, but loose edge 0 does so "
                "already",
                "loose edge 4 joins vertices 1 and 0, but an edge of face 0 "
                "does so already"});
}

TEST_CASE("defects come by face, by edge, then duplicates and loose edges") {
    // Faces 3 and 4 are one face; 0 and 5 have defects of their own.
    const IndexedMesh mesh =
        mesh_of(6, {{9}, {4, 5, 3}, {5, 3, 1}, {0, 1, 2}, {2, 0, 1}, {2, 2, 1}},
                {{7, 0}, {1, 1}});
    std::vector<DefectKind> kinds;
    std::vector<int> first;
    for (const Defect& d : defects(mesh)) {
        kinds.push_back(d.kind);
        first.push_back(d.faces.empty() ? d.loose_edges[0] : d.faces[0]);
    }
    using enum DefectKind;
    CHECK(kinds == std::vector{too_few_corners, index_out_of_range,
                               repeated_vertex, faces_wound_alike,
                               faces_wound_alike, faces_wound_alike,
                               faces_wound_alike, duplicate_face,
                               loose_edge_out_of_range, loose_edge_equal_ends});
    CHECK(first == std::vector{0, 0, 5, 3, 3, 3, 1, 3, 0, 1});
}

TEST_CASE("build throws all defects at once, one to a line") {
    const IndexedMesh mesh = mesh_of(5, {{0, 1}, {0, 1, 9}, {3, 3, 4}});
    try {
        build(mesh);
        FAIL("nothing was thrown");
    } catch (const BuildError& error) {
        CHECK(error.defects() == defects(mesh));
        CHECK(std::string(error.what()) ==
              "face 0 has 2 corners, but a face has at least 3\n"
              "face 1, corner 2: the vertex is 9, but the mesh has 5 vertices, "
              "numbered from 0\n"
              "face 2 names vertex 3 more than once, but the corners of a face "
              "differ");
    }
}

TEST_CASE("the defects of random meshes are those that brute force finds") {
    Random random(20);
    std::map<DefectKind, int> met;
    int sound = 0;
    for (int round = 0; round < 20'000; ++round) {
        const IndexedMesh mesh = random_soup(random);
        const std::vector<Defect> found = defects(mesh);
        INFO(text_of(mesh));
        std::set<Key> keys;
        for (const Defect& defect : found) {
            ++met[defect.kind];
            keys.insert(key_of(defect));
            CHECK(!to_string(defect).empty());
        }
        REQUIRE(keys == all_keys(mesh));
        REQUIRE(keys.size() == found.size());
        sound += found.empty();
        if (found.empty()) REQUIRE(validate(build(mesh)).empty());
        if (!found.empty()) REQUIRE_THROWS_AS(build(mesh), BuildError);
    }
    CHECK(met.size() == 9);
    for (const auto& [kind, count] : met) CHECK(count > 50);
    CHECK(sound > 500);
}

TEST_CASE("tables of random sound meshes hold their faces and nothing else") {
    Random random(21);
    int bow_ties = 0;
    int loose = 0;
    for (int round = 0; round < 3000; ++round) {
        const IndexedMesh mesh = random_sound_mesh(random);
        INFO(text_of(mesh));
        const HalfEdgeTable he = build(mesh);
        REQUIRE(validate(he).empty());
        REQUIRE(rotated_faces(to_faces(he)) == rotated_faces(mesh.faces));
        REQUIRE(edges_of(loose_edges(he)) == edges_of(mesh.loose_edges));
        std::set<std::pair<int, int>> edges = edges_of(mesh.loose_edges);
        for (const auto face : mesh.faces)
            for (std::size_t k = 0; k < face.size(); ++k)
                edges.insert(
                    std::minmax({face[k], face[(k + 1) % face.size()]}));
        REQUIRE(at(he.size()) == 2 * edges.size());
        bow_ties += !bow_tie_vertices(mesh).empty();
        loose += !mesh.loose_edges.empty();
    }
    CHECK(bow_ties > 500);
    CHECK(loose > 500);
}

TEST_CASE("one walk meets all borders and loose edges of a vertex") {
    Random random(22);
    for (int round = 0; round < 1000; ++round) {
        const IndexedMesh mesh = random_sound_mesh(random);
        INFO(text_of(mesh));
        const HalfEdgeTable he = build(mesh);
        std::map<int, std::set<int>> outgoing_borders;
        for (int i = 0; i < he.size(); ++i)
            if (he[i].fi == -1) outgoing_borders[he[i].vi].insert(i);
        for (const auto& [vertex, borders] : outgoing_borders) {
            const std::set<int> met = star(he, *borders.begin());
            REQUIRE(std::includes(met.begin(), met.end(), borders.begin(),
                                  borders.end()));
        }
    }
}

TEST_CASE("bow-ties of random meshes are those that brute force finds") {
    Random random(23);
    for (int round = 0; round < 5000; ++round) {
        const IndexedMesh mesh =
            round % 2 == 0 ? random_sound_mesh(random) : random_soup(random);
        INFO(text_of(mesh));
        IndexedMesh kept = mesh;
        kept.faces = {};
        for (int f = 0; f < mesh.faces.size(); ++f)
            if (!is_flawed(mesh, f)) kept.faces.push_back(mesh.faces[f]);
        std::vector<int> expected;
        for (int v = 0; v < mesh.vertex_count(); ++v)
            if (fans_at(kept, v) > 1) expected.push_back(v);
        REQUIRE(bow_tie_vertices(mesh) == expected);
    }
}

TEST_CASE("an interior vertex of a bow-tie keeps its closed fans apart") {
    // A tetrahedron and a triangle that meet at vertex 0.
    const IndexedMesh mesh =
        mesh_of(6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}, {0, 4, 5}});
    const HalfEdgeTable he = build(mesh);
    CHECK(validate(he).empty());
    CHECK(closed_fans_at(he, 0) == 1);
}

TEST_CASE("what int cannot number is refused") {
    const std::size_t most = INT_MAX;
    CHECK_NOTHROW(require_countable(most, most, most / 2, 0));
    CHECK_NOTHROW(require_countable(0, 0, most / 2 - 5, 5));
    CHECK_THROWS_AS(require_countable(most + 1, 0, 0, 0), std::length_error);
    CHECK_THROWS_AS(require_countable(0, most + 1, 0, 0), std::length_error);
    CHECK_THROWS_AS(require_countable(0, 0, most / 2 + 1, 0),
                    std::length_error);
    CHECK_THROWS_AS(require_countable(0, 0, 0, most / 2 + 1),
                    std::length_error);
    CHECK_THROWS_AS(require_countable(0, 0, most / 2 - 5, 6),
                    std::length_error);
}

TEST_CASE("a polygon of many sides and a fan of many faces are built") {
    constexpr int n = 100'000;
    IndexedMesh mesh = mesh_of(n + 1, {});
    std::vector<int> polygon;
    for (int v = 0; v < n; ++v) polygon.push_back(v);
    mesh.faces.push_back(polygon);
    CHECK(build(mesh).size() == 2 * n);
    mesh.faces = {};
    for (int v = 0; v < n; ++v) mesh.faces.push_back({n, v, (v + 1) % n});
    const HalfEdgeTable he = build(mesh);
    CHECK(he.size() == 4 * n);
    CHECK(validate(he).empty());
}

TEST_CASE("a hub with the smallest number takes its faces in any order") {
    // Quadratic, thus minutes, if edges waited in one list at the hub.
    constexpr int n = 200'000;
    Random random(24);
    std::vector<int> order;
    for (int k = 0; k < n; ++k) order.push_back(k);
    for (int left = n; left > 1; --left)
        std::swap(order[at(left - 1)], order[at(below(left, random))]);
    IndexedMesh mesh = mesh_of(n + 1, {});
    for (const int k : order) mesh.faces.push_back({0, 1 + k, 1 + (k + 1) % n});
    const HalfEdgeTable he = build(mesh);
    CHECK(he.size() == 4 * n);
    CHECK(validate(he).empty());
    mesh.faces.push_back({0, 1, 2});
    CHECK(defects(mesh).size() == 4);
}

TEST_CASE("faces come back in the order of their numbers") {
    // Two triangles on the edge 0-1; face 1 stands first in the table.
    const HalfEdgeTable he = {{0, 1, 2, 1},  {1, 0, 4, 0},  {1, 1, 3, 6},
                              {2, 1, 0, 7},  {0, 0, 5, 8},  {3, 0, 1, 9},
                              {2, -1, 9, 2}, {0, -1, 6, 3}, {3, -1, 7, 4},
                              {1, -1, 8, 5}};
    REQUIRE(validate(he).empty());
    CHECK(rotated_faces(to_faces(he)) ==
          std::vector<std::vector<int>>{{0, 3, 1}, {0, 1, 2}});
}

TEST_CASE("only edges with no face on either side are loose") {
    // The slide's table, where border half-edges stand before their opposites.
    const HalfEdgeTable slide = {
        {2, -1, 2, 1},  {0, 0, 3, 0},   {0, -1, 6, 5},  {2, 0, 5, 4},
        {1, 1, 11, 3},  {1, 0, 1, 2},   {1, -1, 7, 12}, {4, -1, 10, 15},
        {5, 2, 14, 11}, {3, 2, 8, 10},  {5, -1, 13, 9}, {2, 1, 15, 8},
        {4, 1, 4, 6},   {3, -1, 0, 14}, {2, 2, 9, 13},  {5, 1, 12, 7}};
    CHECK(loose_edges(slide).empty());
    CHECK(loose_edges(add_dangling_edge(slide, 6, 6)) ==
          std::vector<std::array<int, 2>>{{4, 6}});
}

TEST_CASE("a face number that no half-edge has is named") {
    HalfEdgeTable he = build(mesh_of(3, {{0, 1, 2}}));
    for (int i = 0; i < he.size(); i += 2) he[i].fi = 2;
    CHECK_THROWS_WITH(to_faces(he),
                      "face 0 has no half-edge, but there are faces up to 2");
    for (int i = 0; i < he.size(); i += 2) he[i].fi = 1'000'000'000;
    CHECK_THROWS_WITH(to_faces(he),
                      "half-edge 0: fi is 1000000000, but 6 half-edges cannot "
                      "have so many faces");
}

TEST_CASE("a table that is not sound has no faces to give back") {
    HalfEdgeTable he = build(mesh_of(3, {{0, 1, 2}}));
    he[2].next = 77;
    CHECK_THROWS_WITH(to_faces(he),
                      "half-edge 2: next is 77, but the half-edges are 0..5");
    CHECK_THROWS_AS(loose_edges(he), std::invalid_argument);
}

TEST_CASE("a dangling edge hangs from the tip of a border half-edge") {
    const HalfEdgeTable before = build(mesh_of(3, {{0, 1, 2}}));
    for (int border = 0; border < before.size(); ++border) {
        if (before[border].fi != -1) continue;
        const HalfEdgeTable after = add_dangling_edge(before, border, 3);
        const int tip = before[before[border].opp].vi;
        REQUIRE(validate(after).empty());
        CHECK(after.size() == 8);
        CHECK(after[border].next == 6);
        CHECK(after[6] == HalfEdge{tip, -1, 7, 7});
        CHECK(after[7] == HalfEdge{3, -1, before[border].next, 6});
        CHECK(loose_edges(after) == std::vector<std::array<int, 2>>{{tip, 3}});
        CHECK(rotated_faces(to_faces(after)) ==
              rotated_faces(to_faces(before)));
    }
}

TEST_CASE("dangling edges make chains and stars") {
    HalfEdgeTable he = build(mesh_of(2, {}, {{0, 1}}));
    he = add_dangling_edge(he, 0, 2);  // from 1
    he = add_dangling_edge(he, 2, 3);  // from 2, the end of the chain
    he = add_dangling_edge(he, 0, 4);  // from 1 again
    CHECK(validate(he).empty());
    CHECK(edges_of(loose_edges(he)) ==
          std::set<std::pair<int, int>>{{0, 1}, {1, 2}, {2, 3}, {1, 4}});
    CHECK(star(he, 1).size() == 3);
}

TEST_CASE("a dangling edge is refused off the border") {
    const HalfEdgeTable he = build(mesh_of(3, {{0, 1, 2}}));
    CHECK_THROWS_WITH(
        add_dangling_edge(he, 0, 3),
        "half-edge 0 runs along face 0, but a dangling edge needs the border");
    CHECK_THROWS_WITH(add_dangling_edge(he, 6, 3),
                      "half-edge 6 does not exist: the table has 6 half-edges");
    CHECK_THROWS_AS(add_dangling_edge(he, -1, 3), std::invalid_argument);
    CHECK_THROWS_AS(add_dangling_edge(he, 1, -1), std::invalid_argument);
}

}  // namespace course
