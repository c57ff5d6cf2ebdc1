// Tables of thousands of generated meshes, compared row by row with what the
// face list alone says.
#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "course/halfedge/build.h"
#include "course/halfedge/validate.h"
#include "course/mesh/generators.h"
#include "course/mesh/zoo.h"
#include "course/runner/catch2.h"
#include "course/tests/halfedge_random.h"
#include "course/tests/mesh_counts.h"

using namespace course;
using namespace course::brute;

namespace {

// ---- meshes

/// Two n-gons and n quads. V = 2n, chi = 2.
IndexedMesh prism(int n) {
    IndexedMesh mesh;
    mesh.positions.resize(at(2 * n));
    std::vector<int> bottom;
    std::vector<int> top;
    for (int k = 0; k < n; ++k) {
        bottom.push_back(n - 1 - k);
        top.push_back(n + k);
    }
    mesh.faces = {};
    mesh.faces.push_back(bottom);
    mesh.faces.push_back(top);
    for (int k = 0; k < n; ++k) {
        const int next = (k + 1) % n;
        mesh.faces.push_back({k, next, n + next, n + k});
    }
    return mesh;
}

/// Both side by side; vertices of b follow those of a.
void append(IndexedMesh& a, const IndexedMesh& b) {
    const int shift = a.vertex_count();
    a.positions.insert(a.positions.end(), b.positions.begin(),
                       b.positions.end());
    for (const auto face : b.faces) {
        std::vector<int> corners(face.begin(), face.end());
        for (int& v : corners) v += shift;
        a.faces.push_back(corners);
    }
    for (const auto& [from, to] : b.loose_edges)
        a.loose_edges.push_back({from + shift, to + shift});
}

FaceList without(const FaceList& faces, const std::set<int>& dropped) {
    FaceList kept;
    for (int f = 0; f < faces.size(); ++f)
        if (dropped.count(f) == 0) kept.push_back(faces[f]);
    return kept;
}

/// The connected sum: a tube of quads in place of the last face of both, which
/// are quads.
IndexedMesh joined(IndexedMesh a, const IndexedMesh& b) {
    const int last = a.faces.size() - 1;
    append(a, b);
    const auto p = a.faces[last];
    const auto q = a.faces[a.faces.size() - 1];
    FaceList faces = without(a.faces, {last, a.faces.size() - 1});
    for (std::size_t k = 0; k < 4; ++k)
        faces.push_back({p[k], p[(k + 1) % 4], q[(7 - k) % 4], q[(4 - k) % 4]});
    a.faces = faces;
    return a;
}

/// A closed surface of that genus with polygons of 4 and of 3 to 300 sides.
IndexedMesh surface(int genus, Random& random) {
    IndexedMesh mesh = prism(3 + below(298, random));
    for (int g = 0; g < genus; ++g)
        mesh = joined(mesh, torus(3 + below(3, random), 3 + below(3, random)));
    return mesh;
}

IndexedMesh polygons(Random& random) {
    RandomMesh options;
    options.faces = 10 + below(60, random);
    options.parts = 1 + below(2, random);
    options.max_sides = 4 + below(12, random);
    options.merge_percent = below(101, random);
    options.hole_percent = below(30, random);
    options.surface = static_cast<Surface>(below(3, random));
    options.bow_ties = static_cast<BowTies>(below(2, random));
    options.unused = static_cast<Unused>(below(2, random));
    return random_polygons(random(), options);
}

IndexedMesh part(Random& random) {
    const int kind = below(8, random);
    if (kind == 0) return surface(below(6, random), random);
    if (kind < 4) return random_sound_mesh(random);
    return polygons(random);
}

void drop_some_faces(IndexedMesh& mesh, Random& random) {
    std::set<int> dropped;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (below(10, random) == 0) dropped.insert(f);
    mesh.faces = without(mesh.faces, dropped);
}

/// Vertices and faces in another order, faces from another corner.
IndexedMesh shuffled(const IndexedMesh& mesh, Random& random) {
    const auto order = [&](std::size_t n) {
        std::vector<int> numbers(n);
        std::iota(numbers.begin(), numbers.end(), 0);
        for (std::size_t left = n; left > 1; --left)
            std::swap(numbers[left - 1], numbers[random() % left]);
        return numbers;
    };
    const std::vector<int> vertex = order(mesh.positions.size());
    IndexedMesh other{mesh.positions, {}, {}};
    for (const int f : order(at(mesh.faces.size()))) {
        std::vector<int> corners;
        for (const int v : mesh.faces[f]) corners.push_back(vertex[at(v)]);
        const int first = below(static_cast<int>(corners.size()), random);
        std::rotate(corners.begin(), corners.begin() + first, corners.end());
        other.faces.push_back(corners);
    }
    for (const auto& [a, b] : mesh.loose_edges)
        other.loose_edges.push_back({vertex[at(a)], vertex[at(b)]});
    return other;
}

/// Makes one vertex of two that are in different parts: a bow-tie.
void weld(IndexedMesh& mesh, int v, int other) {
    FaceList faces;
    for (const auto face : mesh.faces) {
        std::vector<int> corners(face.begin(), face.end());
        std::replace(corners.begin(), corners.end(), other, v);
        faces.push_back(corners);
    }
    mesh.faces = faces;
    for (auto& edge : mesh.loose_edges)
        std::replace(edge.begin(), edge.end(), other, v);
}

/// A chain of loose edges from a vertex to new ones.
void add_chain(IndexedMesh& mesh, Random& random) {
    int from = below(mesh.vertex_count(), random);
    for (int k = below(4, random); k >= 0; --k) {
        mesh.loose_edges.push_back({from, mesh.vertex_count()});
        from = mesh.vertex_count();
        mesh.positions.emplace_back();
    }
}

/// Everything that has a table: one to four parts, some welded at a vertex,
/// with holes, loose edges and vertices that nothing uses.
IndexedMesh anything(Random& random) {
    IndexedMesh mesh = part(random);
    for (int more = below(4, random); more > 0; --more) {
        const int before = mesh.vertex_count();
        append(mesh, part(random));
        if (below(2, random) == 0)
            weld(mesh, below(before, random),
                 before + below(mesh.vertex_count() - before, random));
    }
    if (below(2, random) == 0) drop_some_faces(mesh, random);
    for (int chains = below(4, random); chains > 0; --chains)
        add_chain(mesh, random);
    mesh.positions.resize(mesh.positions.size() + at(below(3, random)));
    return shuffled(mesh, random);
}

// ---- what the faces say

/// A side of a face: the face, and the vertex after its tip.
struct Side {
    int face;
    int after;
};

using Sides = std::map<std::pair<int, int>, Side>;

Sides sides_of(const IndexedMesh& mesh) {
    Sides sides;
    for (int f = 0; f < mesh.faces.size(); ++f) {
        const auto face = mesh.faces[f];
        const std::size_t n = face.size();
        for (std::size_t k = 0; k < n; ++k)
            sides[{face[k], face[(k + 1) % n]}] = {f, face[(k + 2) % n]};
    }
    return sides;
}

/// How many walks round a vertex there must be: one for each closed fan, and
/// one through all other edges at it.
int stars_at(int v, const std::set<int>& neighbours, const Sides& sides) {
    std::set<int> left = neighbours;
    int stars = 0;
    for (int u : neighbours) {
        if (sides.count({v, u}) > 0) continue;
        stars = 1;
        for (;;) {
            left.erase(u);
            const auto side = sides.find({u, v});
            if (side == sides.end()) break;
            u = side->second.after;
        }
    }
    for (; !left.empty(); ++stars)
        for (int u = *left.begin(); left.erase(u) > 0;)
            u = sides.at({u, v}).after;
    return stars;
}

std::map<int, std::set<int>> neighbours_of(const IndexedMesh& mesh) {
    std::map<int, std::set<int>> neighbours;
    for (const auto& [edge, faces] : edges_of(mesh)) {
        neighbours[edge.first].insert(edge.second);
        neighbours[edge.second].insert(edge.first);
    }
    return neighbours;
}

std::set<std::pair<int, int>> edges_of(
    const std::vector<std::array<int, 2>>& edges) {
    std::set<std::pair<int, int>> sorted;
    for (const auto& [a, b] : edges) sorted.insert(std::minmax({a, b}));
    return sorted;
}

/// How many defects of each kind there are.
std::map<DefectKind, int> flaws_of(const IndexedMesh& mesh) {
    std::map<DefectKind, int> count;
    IndexedMesh sound{mesh.positions, {}, {}};
    std::map<std::vector<int>, int> same;
    for (const auto face : mesh.faces) {
        const std::set<int> distinct(face.begin(), face.end());
        if (face.size() < 3) ++count[DefectKind::too_few_corners];
        for (const int v : face)
            if (v < 0 || v >= mesh.vertex_count())
                ++count[DefectKind::index_out_of_range];
        for (const int v : distinct)
            if (std::count(face.begin(), face.end(), v) > 1)
                ++count[DefectKind::repeated_vertex];
        if (!is_sound(mesh, face)) continue;
        sound.faces.push_back(face);
        if (++same[from_smallest(face)] == 2)
            ++count[DefectKind::duplicate_face];
    }
    for (const auto& [edge, faces] : uses_of(sound)) {
        if (faces.size() > 2) ++count[DefectKind::edge_with_many_faces];
        if (faces.size() == 2 && is_alike(faces))
            ++count[DefectKind::faces_wound_alike];
    }
    return count;
}

// ---- comparing

/// The first half-edge whose vertex, face or next is not as the faces say; -1:
/// none. What is left open is which border half-edge comes after another.
int wrong_row(const HalfEdgeTable& he, const Sides& sides) {
    std::set<std::pair<int, int>> met;
    for (int i = 0; i < he.size(); ++i) {
        const auto& [v, f, next, opp] = he.rows()[at(i)];
        const int to = he[opp].vi;
        if (!met.insert({v, to}).second) return i;
        if (he[next].vi != to || he[next].fi != f) return i;
        const auto side = sides.find({v, to});
        if (f != (side == sides.end() ? -1 : side->second.face)) return i;
        if (f != -1 && he[he[next].opp].vi != side->second.after) return i;
    }
    return -1;
}

std::map<int, int> stars_of(const HalfEdgeTable& he) {
    std::map<int, int> stars;
    std::vector<bool> seen(at(he.size()));
    for (int start = 0; start < he.size(); ++start) {
        if (seen[at(start)]) continue;
        ++stars[he[start].vi];
        for (int i = start; !seen[at(i)]; i = he[he[i].opp].next)
            seen[at(i)] = true;
    }
    return stars;
}

void require_table_of(const IndexedMesh& mesh, const HalfEdgeTable& he) {
    const Sides sides = sides_of(mesh);
    REQUIRE(validate(he).empty());
    REQUIRE(at(he.size()) == 2 * brute::edges_of(mesh).size());
    REQUIRE(wrong_row(he, sides) == -1);
    std::map<int, int> stars;
    for (const auto& [v, neighbours] : neighbours_of(mesh))
        stars[v] = stars_at(v, neighbours, sides);
    REQUIRE(stars_of(he) == stars);
    REQUIRE(rotated_faces(to_faces(he)) == rotated_faces(mesh.faces));
    REQUIRE(edges_of(loose_edges(he)) == edges_of(mesh.loose_edges));
}

/// What a generated mesh has, by name.
void note(std::map<std::string, int>& met, const IndexedMesh& mesh,
          const HalfEdgeTable& he) {
    const int used = vertices_of(mesh);
    const std::vector<int> loops = loops_of(he);
    std::size_t most = 0;
    for (const auto face : mesh.faces) most = std::max(most, face.size());
    met["closed"] += !mesh.faces.empty() && loops.empty();
    met["one border"] += loops.size() == 1;
    met["several borders"] += loops.size() > 1;
    met["several components"] += components_of(mesh).size() > 1;
    met["isolated vertices"] += used < mesh.vertex_count();
    met["loose edges"] += !mesh.loose_edges.empty();
    met["bow-ties"] += !bow_tie_vertices(mesh).empty();
    met["large faces"] += most > 100;
}

/// The other linkings: at vertices where two border half-edges come in, the
/// ones after them change places.
int relinked(HalfEdgeTable& he, Random& random) {
    std::map<int, std::vector<int>> in;  // border half-edges by their tip
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) in[he[he[i].opp].vi].push_back(i);
    int swaps = 0;
    for (const auto& [v, borders] : in) {
        if (borders.size() < 2 || below(3, random) == 0) continue;
        std::swap(he[borders[0]].next, he[borders[1]].next);
        ++swaps;
    }
    return swaps;
}

}  // namespace

TEST_CASE("tables of thousands of meshes are what their faces say") {
    std::map<std::string, int> met;
    for (std::uint64_t seed = 0; seed < 2000; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        const IndexedMesh mesh = anything(random);
        const HalfEdgeTable he = build(mesh);
        require_table_of(mesh, he);
        if (mesh.loose_edges.empty() && bow_tie_vertices(mesh).empty())
            REQUIRE(loops_of(he).size() == at(border_circles_of(mesh)));
        note(met, mesh, he);
    }
    CHECK(met.size() == 8);
    for (const auto& [what, n] : met) {
        INFO(what);
        CHECK(n > 30);
    }
}

TEST_CASE("closed surfaces have the genus with which they were made") {
    for (std::uint64_t seed = 0; seed < 120; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        const int genus = static_cast<int>(seed % 6);
        const IndexedMesh mesh = shuffled(surface(genus, random), random);
        const HalfEdgeTable he = build(mesh);
        require_table_of(mesh, he);
        CHECK(loops_of(he).empty());
        CHECK(components_of(mesh).size() == 1);
        CHECK(mesh.vertex_count() - he.size() / 2 + to_faces(he).size() ==
              2 - 2 * genus);
    }
}

TEST_CASE("bow-ties are sound in all their linkings") {
    int swaps = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        const IndexedMesh mesh = anything(random);
        HalfEdgeTable he = build(mesh);
        swaps += relinked(he, random);
        REQUIRE(validate(he).empty());
        REQUIRE(wrong_row(he, sides_of(mesh)) == -1);
        REQUIRE(rotated_faces(to_faces(he)) == rotated_faces(mesh.faces));
        REQUIRE(edges_of(loose_edges(he)) == edges_of(mesh.loose_edges));
    }
    CHECK(swaps > 500);
}

TEST_CASE("a table built from its own faces has the same edges and faces") {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        IndexedMesh mesh = anything(random);
        const HalfEdgeTable he = build(mesh);
        mesh.faces = to_faces(he);
        mesh.loose_edges = loose_edges(he);
        require_table_of(mesh, build(mesh));
    }
}

TEST_CASE("flaws in large meshes are counted as their faces say") {
    std::map<DefectKind, int> met;
    for (std::uint64_t seed = 0; seed < 800; ++seed) {
        INFO("seed " << seed);
        Random random(seed);
        IndexedMesh mesh = anything(random);
        mesh.loose_edges.clear();
        mesh = spoilt(mesh, random);
        const std::map<DefectKind, int> expected = flaws_of(mesh);
        std::map<DefectKind, int> found;
        for (const Defect& defect : defects(mesh)) ++found[defect.kind];
        REQUIRE(found == expected);
        if (expected.empty()) require_table_of(mesh, build(mesh));
        if (!expected.empty()) REQUIRE_THROWS_AS(build(mesh), BuildError);
        for (const auto& [kind, n] : expected) met[kind] += n;
    }
    CHECK(met.size() == 6);
}

TEST_CASE("surfaces without two sides have no table, however they are turned") {
    Random random(50);
    for (const Fixture& fixture :
         {zoo::moebius3q(), zoo::moebius5(), zoo::klein4x4(), zoo::rp2_6()}) {
        INFO(fixture.name);
        for (int round = 0; round < 200; ++round) {
            IndexedMesh mesh{fixture.mesh.positions, {}, {}};
            for (const auto face : fixture.mesh.faces) {
                std::vector<int> corners(face.begin(), face.end());
                if (below(2, random) == 0) corners = turned(corners);
                mesh.faces.push_back(corners);
            }
            mesh = shuffled(mesh, random);
            const std::vector<Defect> found = defects(mesh);
            REQUIRE_FALSE(found.empty());
            for (const Defect& defect : found)
                REQUIRE(defect.kind == DefectKind::faces_wound_alike);
        }
    }
}
