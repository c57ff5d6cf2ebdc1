// Hidden suite of adjacency. The lists are compared with what a search of all
// faces finds for each pair of vertices; edges are told by their ends.
#include "exercises/05_structures/adjacency.h"

#include <algorithm>
#include <map>
#include <set>

#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

using namespace course;

namespace {

using Ends = std::array<int, 2>;

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

Ends joining(int a, int b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Each edge of the mesh, with its faces.
std::map<Ends, std::vector<int>> edges_of(const IndexedMesh& mesh) {
    std::map<Ends, std::vector<int>> edges;
    for (const Ends& loose : mesh.loose_edges)
        edges[joining(loose[0], loose[1])];
    for (int f = 0; f < mesh.faces.size(); ++f) {
        int last = mesh.faces[f].back();
        for (const int v : mesh.faces[f]) {
            edges[joining(last, v)].push_back(f);
            last = v;
        }
    }
    return edges;
}

/// The faces that have v as a corner.
std::vector<int> faces_at(const IndexedMesh& mesh, int v) {
    std::vector<int> faces;
    for (int f = 0; f < mesh.faces.size(); ++f)
        if (std::find(mesh.faces[f].begin(), mesh.faces[f].end(), v) !=
            mesh.faces[f].end())
            faces.push_back(f);
    return faces;
}

Ends ends(const Adjacency& got, int e) {
    if (e < 0 || at(e) >= got.edges.size()) return {-1, -1};
    return joining(got.edges[at(e)].vertices[0], got.edges[at(e)].vertices[1]);
}

/// The answer, which has entries for all elements and each edge once: that is
/// required here.
Adjacency answer(const IndexedMesh& mesh) {
    Adjacency got = adjacency(mesh);
    REQUIRE(got.vertices.size() == mesh.positions.size());
    REQUIRE(got.faces.size() == at(mesh.faces.size()));
    std::vector<Ends> expected, found;
    for (const auto& [ends, faces] : edges_of(mesh)) expected.push_back(ends);
    for (std::size_t e = 0; e < got.edges.size(); ++e)
        found.push_back(ends(got, static_cast<int>(e)));
    std::sort(found.begin(), found.end());
    REQUIRE(found == expected);
    return got;
}

void check_faces(const IndexedMesh& mesh, const Adjacency& got) {
    for (int f = 0; f < mesh.faces.size(); ++f) {
        INFO("face " << f);
        const auto corners = mesh.faces[f];
        const std::size_t n = corners.size();
        const FaceLinks& face = got.faces[at(f)];
        REQUIRE(face.vertices ==
                std::vector<int>(corners.begin(), corners.end()));
        REQUIRE(face.edges.size() == n);
        for (std::size_t i = 0; i < n; ++i)
            REQUIRE(ends(got, face.edges[i]) ==
                    joining(corners[i], corners[(i + 1) % n]));
    }
}

void check_edges(const IndexedMesh& mesh, const Adjacency& got) {
    const auto edges = edges_of(mesh);
    for (std::size_t e = 0; e < got.edges.size(); ++e) {
        const Ends joined = ends(got, static_cast<int>(e));
        INFO("edge between " << joined[0] << " and " << joined[1]);
        REQUIRE_THAT(got.edges[e].faces, IsPermutationOf(edges.at(joined)));
    }
}

void check_vertices(const IndexedMesh& mesh, const Adjacency& got) {
    const auto edges = edges_of(mesh);
    for (int v = 0; v < mesh.vertex_count(); ++v) {
        INFO("vertex " << v);
        REQUIRE_THAT(got.vertices[at(v)].faces,
                     IsPermutationOf(faces_at(mesh, v)));
        std::vector<Ends> found, expected;
        for (const int e : got.vertices[at(v)].edges)
            found.push_back(ends(got, e));
        std::sort(found.begin(), found.end());
        for (const auto& [joined, faces] : edges)
            if (joined[0] == v || joined[1] == v) expected.push_back(joined);
        REQUIRE(found == expected);
    }
}

/// Whether no face comes to one vertex twice.
bool has_simple_faces(const IndexedMesh& mesh) {
    return std::all_of(mesh.faces.begin(), mesh.faces.end(), [](auto face) {
        return std::set<int>(face.begin(), face.end()).size() == face.size();
    });
}

std::vector<Fixture> made_by_hand() {
    std::vector<Fixture> fixtures = hidden::made_by_hand();
    std::erase_if(fixtures, [](const Fixture& fixture) {
        return !has_simple_faces(fixture.mesh);
    });
    return fixtures;
}

/// Meshes that no half-edge table holds: edges with many faces, windings that
/// do not agree, faces that are there twice.
std::vector<Fixture> without_table() {
    std::vector<Fixture> fixtures = {zoo::fan3(),      zoo::house_with_wall(),
                                     zoo::moebius3q(), zoo::moebius5(),
                                     zoo::rp2_6(),     zoo::klein4x4()};
    Fixture flipped{"cube, one face flipped", zoo::cube().mesh, {}};
    flipped.mesh.faces = {{0, 2, 6, 4}, {0, 1, 3, 2}, {6, 7, 3, 2},
                          {4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}};
    Fixture twice{"a triangle, three times", zoo::triangle().mesh, {}};
    twice.mesh.faces = {{0, 1, 2}, {0, 1, 2}, {2, 1, 0}};
    fixtures.push_back(flipped);
    fixtures.push_back(twice);
    return fixtures;
}

}  // namespace

TEST_CASE("each face with its corners and edges, in step", "[points:2]") {
    hint("Which corners does edge i of a face join, and which does the last?");
    for (const Fixture& fixture : made_by_hand()) {
        const OnMesh on(fixture);
        check_faces(fixture.mesh, answer(fixture.mesh));
    }
}

TEST_CASE("each edge with its faces", "[points:1]") {
    hint("Who tells an edge about the second face that has it?");
    for (const Fixture& fixture : made_by_hand()) {
        const OnMesh on(fixture);
        check_edges(fixture.mesh, answer(fixture.mesh));
    }
}

TEST_CASE("each vertex with its edges and faces", "[points:1]") {
    hint("How often does a vertex hear of an edge that two faces have?");
    for (const Fixture& fixture : made_by_hand()) {
        const OnMesh on(fixture);
        check_vertices(fixture.mesh, answer(fixture.mesh));
    }
}

TEST_CASE("isolated vertices, loose edges, and no faces at all", "[points:1]") {
    hint("Which vertices and edges does no face name?");
    IndexedMesh sparse = zoo::slide().mesh;
    sparse.positions.insert(sparse.positions.end(), {{7, 0}, {8, 0}, {9, 0}});
    sparse.loose_edges = {{8, 4}, {6, 8}, {0, 5}};
    IndexedMesh no_faces{{{0, 0}, {1, 0}, {2, 0}}, {}, {{2, 0}}};
    IndexedMesh points{{{0, 0}, {1, 0}}, {}, {}};
    for (const IndexedMesh& mesh : {sparse, no_faces, points}) {
        const Adjacency got = answer(mesh);
        check_faces(mesh, got);
        check_edges(mesh, got);
        check_vertices(mesh, got);
    }
    CHECK(adjacency(IndexedMesh()) == Adjacency());
}

TEST_CASE("meshes that are no surfaces", "[points:1]") {
    hint("How many faces may an edge have here, and in which direction?");
    for (const Fixture& fixture : without_table()) {
        const OnMesh on(fixture);
        const Adjacency got = answer(fixture.mesh);
        check_faces(fixture.mesh, got);
        check_edges(fixture.mesh, got);
        check_vertices(fixture.mesh, got);
    }
}

TEST_CASE("renumbered and generated meshes", "[points:1]") {
    hint("Which of your steps relies on how vertices are numbered?");
    std::vector<Fixture> fixtures = generated_fixtures();
    for (const Fixture& fixture : hidden::renumbered_copies())
        if (has_simple_faces(fixture.mesh)) fixtures.push_back(fixture);
    for (const Fixture& fixture : fixtures) {
        const OnMesh on(fixture);
        const Adjacency got = answer(fixture.mesh);
        check_faces(fixture.mesh, got);
        check_edges(fixture.mesh, got);
        check_vertices(fixture.mesh, got);
    }
}

TEST_CASE("the cost grows hardly faster than the mesh", "[points:1][once]") {
    hint("How do you find out whether an edge has a number already?");
    constexpr int n = 75;
    const IndexedMesh mesh = grid(n, n);
    const Adjacency got = adjacency(mesh);
    CHECK(got.vertices.size() == (n + 1) * (n + 1));
    REQUIRE(got.edges.size() == 2 * n * (n + 1));
    CHECK(got.faces.size() == n * n);
    std::size_t sides = 0;
    for (const EdgeLinks& edge : got.edges) sides += edge.faces.size();
    CHECK(sides == 4 * n * n);
}
