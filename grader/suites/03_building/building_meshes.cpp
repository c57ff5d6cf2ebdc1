#include "grader/suites/03_building/building_meshes.h"

#include <algorithm>
#include <cmath>
#include <random>
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

using Random = std::mt19937_64;

/// The list in any order; the same for the same state on every platform.
template <class T>
void shuffle(std::vector<T>& list, Random& random) {
    for (std::size_t k = list.size(); k > 1; --k)
        std::swap(list[k - 1], list[random() % k]);
}

std::vector<std::vector<int>> lists_of(const FaceList& faces) {
    std::vector<std::vector<int>> lists;
    for (const FaceList::Face face : faces)
        lists.emplace_back(face.begin(), face.end());
    return lists;
}

FaceList faces_of(const std::vector<std::vector<int>>& lists) {
    FaceList faces;
    for (const std::vector<int>& list : lists) faces.push_back(list);
    return faces;
}

std::vector<Vec3> on_a_circle(int vertices) {
    std::vector<Vec3> positions;
    for (int v = 0; v < vertices; ++v) {
        const double angle = 2 * 3.14159265358979 * v / vertices;
        positions.push_back({std::cos(angle), std::sin(angle), 0});
    }
    return positions;
}

Fixture generated(const RandomMesh& options, std::uint64_t salt) {
    IndexedMesh mesh = random_polygons(seed() * 100 + salt, options);
    HalfEdgeTable he = build(mesh);
    return {"generated mesh " + std::to_string(salt), std::move(mesh),
            std::move(he)};
}

}  // namespace

Fixture of_faces(std::string name, int vertices,
                 std::initializer_list<std::initializer_list<int>> faces) {
    return {std::move(name), {on_a_circle(vertices), faces, {}}, {}};
}

Fixture of_mesh(std::string name, IndexedMesh mesh) {
    return {std::move(name), std::move(mesh), {}};
}

Fixture put_in_another_order(const Fixture& fixture, std::uint64_t salt) {
    Random random(seed() * 1000 + salt);
    const int vertices = fixture.mesh.vertex_count();
    const int with_gaps = vertices + vertices / 5 + 1;
    std::vector<int> names;
    for (int v = 0; v < with_gaps; ++v) names.push_back(v);
    shuffle(names, random);

    IndexedMesh mesh;
    mesh.positions.resize(at(with_gaps));
    for (int v = 0; v < vertices; ++v)
        mesh.positions[at(names[at(v)])] = fixture.mesh.positions[at(v)];
    std::vector<std::vector<int>> faces = lists_of(fixture.mesh.faces);
    for (std::vector<int>& face : faces) {
        for (int& v : face) v = names[at(v)];
        std::rotate(
            face.begin(),
            face.begin() + static_cast<std::ptrdiff_t>(random() % face.size()),
            face.end());
    }
    shuffle(faces, random);
    mesh.faces = faces_of(faces);
    for (const auto& [a, b] : fixture.mesh.loose_edges)
        mesh.loose_edges.push_back({names[at(b)], names[at(a)]});
    shuffle(mesh.loose_edges, random);
    return {fixture.name + ", in another order", std::move(mesh), {}};
}

Fixture with_faces_reversed(const Fixture& fixture,
                            const std::vector<int>& faces) {
    std::vector<std::vector<int>> lists = lists_of(fixture.mesh.faces);
    std::string name = fixture.name + ", faces turned over:";
    for (const int f : faces) {
        std::reverse(lists[at(f)].begin(), lists[at(f)].end());
        name += " " + std::to_string(f);
    }
    IndexedMesh mesh = fixture.mesh;
    mesh.faces = faces_of(lists);
    return {std::move(name), std::move(mesh), {}};
}

Fixture beside_each_other(const std::vector<Fixture>& parts) {
    Fixture all{"", {}, {}};
    for (const Fixture& part : parts) {
        all.name += (all.name.empty() ? "" : " beside ") + part.name;
        const int first = all.mesh.vertex_count();
        for (const Vec3& p : part.mesh.positions)
            all.mesh.positions.push_back(p + Vec3{0.3 * first, 0, 0});
        for (std::vector<int>& face : lists_of(part.mesh.faces)) {
            for (int& v : face) v += first;
            all.mesh.faces.push_back(face);
        }
        for (const auto& [a, b] : part.mesh.loose_edges)
            all.mesh.loose_edges.push_back({a + first, b + first});
    }
    return all;
}

Fixture double_cone(int sides) {
    IndexedMesh mesh{on_a_circle(sides + 2), {}, {}};
    for (int k = 0; k < sides; ++k) {
        const int a = 2 + k;
        const int b = 2 + (k + 1) % sides;
        mesh.faces.push_back({0, a, b});
        mesh.faces.push_back({1, b, a});
    }
    return {"double cone", std::move(mesh), {}};
}

std::vector<Fixture> closed_meshes() {
    return {zoo::tetra(),  zoo::cube(),      zoo::house(), zoo::torus7(),
            zoo::pillow(), zoo::hourglass(), prism(),      bipyramid(),
            ring_closed(), two_tori()};
}

std::vector<Fixture> open_meshes_with_table() {
    return {zoo::slide(),
            zoo::triangle(),
            zoo::annulus(),
            zoo::lens(),
            zoo::fan6(),
            zoo::two_triangles(),
            twelve_gon(),
            ring_of_two(),
            gaps(),
            open_then_closed(),
            closed_then_open(),
            zoo::bow_tie_crossed(),
            zoo::bow_tie_separate(),
            pinwheel_in_turn()};
}

std::vector<Fixture> with_loose_edges() {
    return {zoo::dangling(), loose_edge_after(), loose_edge_before(),
            loose_chain(),   loose_pair(),       thorn(),
            bridge()};
}

std::vector<Fixture> generated_closed() {
    std::vector<Fixture> fixtures;
    for (std::uint64_t k = 0; k < 4; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k % 2);
        options.surface = Surface::closed;
        fixtures.push_back(generated(options, k));
    }
    return fixtures;
}

std::vector<Fixture> generated_open() {
    std::vector<Fixture> fixtures = generated_fixtures();
    for (std::uint64_t k = 10; k < 14; ++k) {
        RandomMesh options;
        options.faces = 60;
        options.parts = 2;
        options.hole_percent = 20;
        options.surface = k % 2 == 0 ? Surface::open : Surface::mixed;
        options.bow_ties = BowTies::allowed;
        options.unused = Unused::kept;
        fixtures.push_back(generated(options, k));
    }
    return fixtures;
}

}  // namespace course::hidden
