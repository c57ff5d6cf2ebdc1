#include "grader/suites/05_structures/structures_meshes.h"

#include <algorithm>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"
#include "grader/suites/meshes.h"

namespace course::hidden {

namespace {

bool only_triangles(const Fixture& fixture) {
    return fixture.mesh.loose_edges.empty() &&
           std::all_of(fixture.mesh.faces.begin(), fixture.mesh.faces.end(),
                       [](auto face) { return face.size() == 3; });
}

}  // namespace

std::vector<Fixture> triangle_meshes() {
    std::vector<Fixture> meshes = made_by_hand();
    std::erase_if(meshes, [](const Fixture& fixture) {
        return !only_triangles(fixture);
    });
    return meshes;
}

std::vector<Fixture> generated_triangle_meshes() {
    std::vector<IndexedMesh> meshes = {
        icosphere(1), torus(5, 4, Cells::triangles),
        torus(12, 3, Cells::triangles), grid(4, 3, Cells::triangles),
        grid(9, 1, Cells::triangles)};
    for (std::uint64_t k = 0; k < 4; ++k) {
        RandomMesh options;
        options.faces = 40;
        options.parts = 1 + static_cast<int>(k) % 2;
        options.merge_percent = 0;
        options.surface = k < 2 ? Surface::open : Surface::mixed;
        options.bow_ties = BowTies::allowed;
        meshes.push_back(random_polygons(seed() * 100 + k, options));
    }
    std::vector<Fixture> fixtures;
    for (const IndexedMesh& mesh : meshes) {
        const std::size_t k = fixtures.size();
        const Fixture fixture{"triangle mesh " + std::to_string(k), mesh,
                              build(mesh)};
        if (only_triangles(fixture)) fixtures.push_back(renumbered(fixture, k));
    }
    return fixtures;
}

Soup torn(const IndexedMesh& mesh) {
    const auto point = [&](int v) {
        return mesh.positions[static_cast<std::size_t>(v)];
    };
    Soup soup;
    for (const auto face : mesh.faces)
        soup.push_back({point(face[0]), point(face[1]), point(face[2])});
    return soup;
}

}  // namespace course::hidden
