// Cleaning: each step by example and against brute force, and that anything at
// all has a half-edge table afterwards.
#include "course/mesh/clean.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"
#include "course/tests/mesh_counts.h"

using namespace course;
using brute::at;
using brute::from_smallest;
using brute::is_alike;
using brute::is_sound;
using brute::uses_of;

namespace {

using Texts = std::vector<std::string>;

/// Vertex v is at (v, 0, 0), so that copies are known by their place.
IndexedMesh mesh_of(int vertices, FaceList faces,
                    std::vector<std::array<int, 2>> loose = {}) {
    IndexedMesh mesh{{}, std::move(faces), std::move(loose)};
    for (int v = 0; v < vertices; ++v)
        mesh.positions.push_back({static_cast<double>(v), 0, 0});
    return mesh;
}

IndexedMesh placed(IndexedMesh mesh) {
    return mesh_of(mesh.vertex_count(), mesh.faces, mesh.loose_edges);
}

Texts texts_of(const Cleaned& cleaned) {
    Texts texts;
    for (const Change& change : cleaned.changes)
        texts.push_back(to_string(change));
    return texts;
}

/// The sound faces only.
IndexedMesh sound_part(const IndexedMesh& mesh) {
    IndexedMesh part = mesh_of(mesh.vertex_count(), {});
    for (const auto face : mesh.faces)
        if (is_sound(mesh, face)) part.faces.push_back(face);
    return part;
}

/// What a face was before vertices got copies, from its smallest vertex.
std::vector<int> origin_of(const IndexedMesh& mesh, FaceList::Face face) {
    std::vector<int> corners;
    for (const int v : face)
        corners.push_back(static_cast<int>(mesh.positions[at(v)].x));
    return from_smallest(corners);
}

/// Fewest faces to turn so that all edges with two faces are sound; -1: none.
int fewest_turns(const IndexedMesh& mesh) {
    const auto uses = uses_of(mesh);
    int fewest = -1;
    for (unsigned flags = 0; flags < 1U << mesh.faces.size(); ++flags) {
        const auto is_right = [&](const auto& edge) {
            const auto& two = edge.second;
            const unsigned both =
                (flags >> two.begin()->first) ^ (flags >> two.rbegin()->first);
            return two.size() != 2 || is_alike(two) == ((both & 1U) == 1);
        };
        const int turns = __builtin_popcount(flags);
        if (std::all_of(uses.begin(), uses.end(), is_right) &&
            (fewest == -1 || turns < fewest))
            fewest = turns;
    }
    return fewest;
}

/// Whether the change proves that the mesh cannot be oriented.
bool is_proof(const IndexedMesh& mesh, const Change& twist) {
    const auto uses = uses_of(mesh);
    const std::size_t n = twist.faces.size();
    if (twist.vertices.size() != 2 * n) return false;
    int alike = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const auto edge = uses.find(
            std::minmax(twist.vertices[2 * k], twist.vertices[2 * k + 1]));
        if (edge == uses.end()) return false;
        const std::set<int> pair = {twist.faces[k], twist.faces[(k + 1) % n]};
        std::set<int> faces;
        for (const auto& [f, up] : edge->second) faces.insert(f);
        if (faces != pair || faces.size() != 2) return false;
        alike += is_alike(edge->second);
    }
    return alike % 2 == 1;
}

int count(const Cleaned& cleaned, ChangeKind kind) {
    return static_cast<int>(
        std::count_if(cleaned.changes.begin(), cleaned.changes.end(),
                      [&](const Change& c) { return c.kind == kind; }));
}

void require_buildable(const IndexedMesh& mesh) {
    REQUIRE(defects(mesh).empty());
    REQUIRE(validate(build(mesh)).empty());
    REQUIRE(bow_tie_vertices(mesh).empty());
}

/// Nothing is made up, and no sound face is lost but for duplicates.
void require_same_faces(const IndexedMesh& mesh, const Cleaned& cleaned) {
    std::set<std::vector<int>> kept;
    REQUIRE(cleaned.face_of.size() == at(cleaned.mesh.faces.size()));
    for (int f = 0; f < cleaned.mesh.faces.size(); ++f) {
        const auto was = mesh.faces[cleaned.face_of[at(f)]];
        const auto is = origin_of(cleaned.mesh, cleaned.mesh.faces[f]);
        kept.insert(is);
        if (is_sound(mesh, was))
            REQUIRE((is == origin_of(mesh, was) ||
                     turned(is) == origin_of(mesh, was)));
        for (const int v : is)
            REQUIRE(std::find(was.begin(), was.end(), v) != was.end());
    }
    for (const auto face : sound_part(mesh).faces) {
        const auto origin = origin_of(mesh, face);
        REQUIRE(kept.count(origin) + kept.count(turned(origin)) > 0);
    }
}

/// A strip of quads closed to a ring, with or without a twist, some of them
/// turned over, and perhaps a wall on it.
IndexedMesh random_ring(Random& random) {
    const int n = 3 + below(6, random);
    const bool is_twisted = below(2, random) == 0;
    IndexedMesh mesh = mesh_of(2 * n + 1, {});
    for (int k = 0; k < n; ++k) {
        int c = (k + 1) % n;
        int d = n + c;
        if (is_twisted && k + 1 == n) std::swap(c, d);
        std::vector<int> quad = {k, c, d, n + k};
        if (below(2, random) == 0) quad = turned(quad);
        mesh.faces.push_back(quad);
    }
    if (below(3, random) == 0) mesh.faces.push_back({0, n, 2 * n});
    return mesh;
}

}  // namespace

TEST_CASE("degenerate faces are dropped, and cut where they meet themselves") {
    const IndexedMesh mesh = mesh_of(6, {{0, 1},
                                         {0, 1, 6},
                                         {0, 1, 2, 2},
                                         {0, 1, 0},
                                         {0, 1, 2, 0, 3, 4},
                                         {3, 4, 5}});
    const Cleaned cleaned = drop_degenerate_faces(mesh);
    CHECK(cleaned.mesh.faces ==
          FaceList{{0, 1, 2}, {0, 1, 2}, {0, 3, 4}, {3, 4, 5}});
    CHECK(cleaned.face_of == std::vector<int>{2, 4, 4, 5});
    CHECK(texts_of(cleaned) ==
          Texts{"face 0 has 2 corners, but a face has at least 3: face 0 "
                "dropped",
                "face 1, corner 2: the vertex is 6, but the mesh has 6 "
                "vertices, numbered from 0: face 1 dropped",
                "face 2 names vertex 2 more than once, but the corners of a "
                "face differ: cut there, 1 face is left",
                "face 3 names vertex 0 more than once, but the corners of a "
                "face differ: face 3 dropped",
                "face 4 names vertex 0 more than once, but the corners of a "
                "face differ: cut there, 2 faces are left"});
}

TEST_CASE("of faces that come again the first is kept") {
    const IndexedMesh mesh =
        mesh_of(4, {{0, 1, 2}, {0, 2, 3}, {1, 2, 0}, {2, 1, 0}, {2, 0, 1}});
    const Cleaned cleaned = drop_duplicate_faces(mesh);
    CHECK(cleaned.mesh.faces == FaceList{{0, 1, 2}, {0, 2, 3}, {2, 1, 0}});
    CHECK(cleaned.face_of == std::vector<int>{0, 1, 3});
    CHECK(texts_of(cleaned) ==
          Texts{"faces 0, 2 and 4 are the same face, with the vertices 0, 1, "
                "2; a face comes once: faces 2 and 4 dropped"});
}

TEST_CASE("loose edges that are none are dropped") {
    const IndexedMesh mesh =
        mesh_of(4, {{0, 1, 2}}, {{0, 3}, {4, 4}, {3, 0}, {2, 1}, {1, 3}});
    const Cleaned cleaned = drop_bad_loose_edges(mesh);
    CHECK(cleaned.mesh.loose_edges ==
          std::vector<std::array<int, 2>>{{0, 3}, {1, 3}});
    CHECK(cleaned.mesh.faces == mesh.faces);
    CHECK(texts_of(cleaned) ==
          Texts{"loose edge 1, end 0: the vertex is 4, but the mesh has 4 "
                "vertices, numbered from 0: dropped",
                "loose edge 2 joins vertices 3 and 0, but loose edge 0 does so "
                "already: dropped",
                "loose edge 3 joins vertices 2 and 1, but an edge of face 0 "
                "does so already: dropped"});
}

TEST_CASE("the fewer faces of each part are turned over") {
    // Two strips of three triangles; in one most are wound clockwise.
    const IndexedMesh mesh = mesh_of(
        10, {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {5, 6, 7}, {6, 7, 8}, {7, 9, 8}});
    const Cleaned cleaned = orient_faces(mesh);
    CHECK(
        cleaned.mesh.faces ==
        FaceList{
            {0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {5, 7, 6}, {6, 7, 8}, {7, 9, 8}});
    CHECK(texts_of(cleaned) ==
          Texts{"face 1 turned over, to be wound as the others",
                "face 3 turned over, to be wound as the others"});
}

TEST_CASE("a Moebius strip is proved by a ring of its faces, and cut once") {
    const IndexedMesh mesh = placed(zoo::moebius5().mesh);
    const Cleaned oriented = orient_faces(mesh);
    REQUIRE(count(oriented, ChangeKind::twist_found) == 1);
    CHECK(is_proof(mesh, oriented.changes[0]));
    CHECK(oriented.changes[0].faces.size() == 5);
    const Cleaned cleaned = clean(mesh);
    CHECK(cleaned.mesh.faces.size() == 5);
    CHECK(cleaned.mesh.vertex_count() == 7);
    CHECK(count(cleaned, ChangeKind::edge_split) == 1);
    CHECK(brute::components_of(cleaned.mesh).size() == 1);
    require_buildable(cleaned.mesh);
}

TEST_CASE("the text of a proof names its faces") {
    CHECK(to_string({.kind = ChangeKind::twist_found, .faces = {3, 0, 2}}) ==
          "faces 3, 0 and 2, each beside the next and the last beside the "
          "first, are a Moebius strip: they cannot all be wound alike");
    std::vector<int> many(100);
    for (int f = 0; f < 100; ++f) many[at(f)] = f;
    CHECK(to_string({.kind = ChangeKind::faces_turned, .faces = many}) ==
          "faces 0, 1, 2, 3, 4, 5, 6, 7 and 92 more turned over, to be wound "
          "as the others");
}

TEST_CASE("a wall comes off a closed surface, which stays closed") {
    // A tetrahedron and a triangle that stands on its edge 0-1.
    const IndexedMesh mesh =
        mesh_of(5, {{0, 1, 4}, {0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
    const Cleaned cleaned = split_non_manifold(mesh);
    CHECK(cleaned.mesh.faces ==
          FaceList{{0, 1, 4}, {5, 6, 2}, {5, 2, 3}, {5, 3, 6}, {6, 3, 2}});
    CHECK(cleaned.mesh.positions[5] == mesh.positions[0]);
    CHECK(texts_of(cleaned) ==
          Texts{"edge 0-1 of faces 0, 1 and 3 becomes 2 edges",
                "vertex 0: faces 1, 2 and 3 now at vertex 5, a copy of it, "
                "since no sound edge joins them to its other faces there",
                "vertex 1: faces 1, 3 and 4 now at vertex 6, a copy of it, "
                "since no sound edge joins them to its other faces there"});
}

TEST_CASE(
    "each fan of a bow-tie gets a vertex, loose edges stay at the first") {
    const IndexedMesh mesh = mesh_of(6, {{0, 1, 2}, {0, 3, 4}}, {{0, 5}});
    const Cleaned cleaned = split_non_manifold(mesh);
    CHECK(cleaned.mesh.faces == FaceList{{0, 1, 2}, {6, 3, 4}});
    CHECK(cleaned.mesh.loose_edges == mesh.loose_edges);
    CHECK(cleaned.changes.size() == 1);
}

TEST_CASE("holes are filled up to a number of sides") {
    IndexedMesh mesh = grid(4, 4);
    FaceList faces;
    for (int f = 0; f < 16; ++f)
        if (f != 5) faces.push_back(mesh.faces[f]);
    mesh.faces = faces;
    const Cleaned filled = fill_holes(mesh, 4);
    CHECK(texts_of(filled) ==
          Texts{"hole of 4 edges filled by a face: vertices 6, 7, 12 and 11"});
    CHECK(filled.mesh.faces[15].size() == 4);
    CHECK(filled.face_of.back() == -1);
    CHECK(brute::border_circles_of(filled.mesh) == 1);
    CHECK(fill_holes(mesh, 3).changes.empty());
    CHECK(brute::border_circles_of(fill_holes(mesh).mesh) == 0);
    CHECK_THROWS_AS(fill_holes(zoo::fan3().mesh), BuildError);
}

TEST_CASE("the borders of a bow-tie are closed one by one") {
    for (const Fixture& tie :
         {zoo::bow_tie_crossed(), zoo::bow_tie_separate()}) {
        const IndexedMesh filled = fill_holes(tie.mesh).mesh;
        CHECK(filled.faces.size() == 4);
        CHECK(brute::border_circles_of(filled) == 0);
        CHECK(defects(filled).empty());
    }
}

TEST_CASE("unused vertices are dropped, and the others move up") {
    const IndexedMesh mesh = mesh_of(7, {{1, 2, 4}, {9, 4, -1}}, {{4, 5}});
    const Cleaned cleaned = drop_unused_vertices(mesh);
    CHECK(cleaned.mesh.faces == FaceList{{0, 1, 2}, {9, 2, -1}});
    CHECK(cleaned.mesh.loose_edges == std::vector<std::array<int, 2>>{{2, 3}});
    CHECK(cleaned.mesh.positions[2] == mesh.positions[4]);
    CHECK(texts_of(cleaned) ==
          Texts{"vertices 0, 3 and 6 dropped: no face and no edge there"});
    CHECK(drop_unused_vertices(cleaned.mesh).changes.empty());
}

TEST_CASE("all changes of a cleaning name faces by their first number") {
    // Face 0 is dropped, 2 is 1 again, 4 is wound against 3 and 5.
    const IndexedMesh mesh = mesh_of(
        9, {{0, 1}, {0, 1, 2}, {2, 0, 1}, {4, 5, 6}, {5, 6, 7}, {6, 7, 8}});
    const Cleaned cleaned = clean(mesh, {.most_sides = 3, .drop_unused = true});
    CHECK(texts_of(cleaned) ==
          Texts{"face 0 has 2 corners, but a face has at least 3: face 0 "
                "dropped",
                "faces 1 and 2 are the same face, with the vertices 0, 1, 2; a "
                "face comes once: face 2 dropped",
                "face 4 turned over, to be wound as the others",
                "hole of 3 edges filled by a face: vertices 1, 0 and 2",
                "vertex 3 dropped: no face and no edge there"});
    CHECK(cleaned.face_of == std::vector<int>{1, 3, 4, 5, -1});
}

TEST_CASE("a mesh that has a table without bow-ties is left as it is") {
    for (const Fixture& fixture : zoo::with_table()) {
        INFO(fixture.name);
        if (!bow_tie_vertices(fixture.mesh).empty()) continue;
        CHECK(clean(fixture.mesh).mesh == fixture.mesh);
        CHECK(clean(fixture.mesh).changes.empty());
    }
    const IndexedMesh mesh = random_polygons(3);
    CHECK(clean(mesh).mesh == mesh);
}

TEST_CASE("the meshes of the zoo without a table get one") {
    for (const Fixture& fixture :
         {zoo::moebius3q(), zoo::moebius5(), zoo::klein4x4(), zoo::rp2_6(),
          zoo::fan3(), zoo::house_with_wall()}) {
        INFO(fixture.name);
        const Cleaned cleaned = clean(fixture.mesh);
        CHECK(cleaned.mesh.faces.size() == fixture.mesh.faces.size());
        require_buildable(cleaned.mesh);
    }
}

TEST_CASE("anything has a table when it is cleaned, and nothing is made up") {
    Random random(30);
    std::map<ChangeKind, int> met;
    for (int round = 0; round < 10'000; ++round) {
        const IndexedMesh mesh = placed(random_soup(random));
        INFO(text_of(mesh));
        const Cleaned cleaned = clean(mesh);
        require_buildable(cleaned.mesh);
        require_same_faces(mesh, cleaned);
        REQUIRE(cleaned.changes.empty() == (cleaned.mesh == mesh));
        REQUIRE(clean(cleaned.mesh).changes.empty());
        const Cleaned full =
            clean(mesh, {.most_sides = 1000, .drop_unused = true});
        require_buildable(full.mesh);
        REQUIRE(brute::vertices_of(full.mesh) == full.mesh.vertex_count());
        for (const auto& [edge, faces] : brute::edges_of(full.mesh))
            REQUIRE(faces != 1);
        for (const Change& change : full.changes) {
            ++met[change.kind];
            REQUIRE(!to_string(change).empty());
        }
    }
    CHECK(met.size() == 9);
    for (const auto& [kind, n] : met) CHECK(n > 20);
}

TEST_CASE("faces are oriented just where brute force can orient them") {
    Random random(31);
    int twists = 0;
    int turns = 0;
    for (int round = 0; round < 6000; ++round) {
        const IndexedMesh mesh = round % 3 == 0
                                     ? random_ring(random)
                                     : sound_part(random_soup(random));
        INFO(text_of(mesh));
        const Cleaned oriented = orient_faces(mesh);
        const int fewest = fewest_turns(mesh);
        REQUIRE((fewest == -1) ==
                (count(oriented, ChangeKind::twist_found) > 0));
        int turned_faces = 0;
        for (const Change& change : oriented.changes) {
            if (change.kind == ChangeKind::faces_turned)
                turned_faces += static_cast<int>(change.faces.size());
            else
                REQUIRE(is_proof(mesh, change));
        }
        twists += fewest == -1;
        turns += turned_faces > 0;
        if (fewest == -1) continue;
        REQUIRE(turned_faces == fewest);
        for (const auto& [edge, faces] : uses_of(oriented.mesh))
            REQUIRE((faces.size() != 2 || !is_alike(faces)));
    }
    CHECK(twists > 500);
    CHECK(turns > 500);
}

TEST_CASE("surfaces are cut no further than they must be") {
    Random random(32);
    for (int round = 0; round < 6000; ++round) {
        const IndexedMesh mesh = round % 3 == 0
                                     ? random_ring(random)
                                     : sound_part(random_soup(random));
        INFO(text_of(mesh));
        const IndexedMesh split = split_non_manifold(mesh).mesh;
        std::set<std::pair<int, int>> neighbours;
        for (const auto& [edge, faces] : uses_of(split)) {
            REQUIRE(
                (faces.size() == 1 || (faces.size() == 2 && !is_alike(faces))));
            if (faces.size() == 2)
                neighbours.insert(
                    {faces.begin()->first, faces.rbegin()->first});
        }
        for (const auto& [edge, faces] : uses_of(mesh))
            if (faces.size() == 2 && !is_alike(faces))
                REQUIRE(neighbours.count({faces.begin()->first,
                                          faces.rbegin()->first}) == 1);
        REQUIRE(bow_tie_vertices(split).empty());
    }
}

TEST_CASE("large meshes with every kind of flaw have tables when cleaned") {
    Random random(33);
    RandomMesh options;
    options.faces = 2000;
    options.parts = 5;
    options.surface = Surface::mixed;
    options.bow_ties = BowTies::allowed;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const IndexedMesh mesh =
            placed(spoilt(random_polygons(seed, options), random));
        INFO("seed " << seed);
        REQUIRE_FALSE(defects(mesh).empty());
        const Cleaned cleaned = clean(mesh);
        require_buildable(cleaned.mesh);
        require_same_faces(mesh, cleaned);
    }
}
