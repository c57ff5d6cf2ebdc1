// The hidden meshes of this chapter. A picture shows vertex numbers.
#include "grader/suites/02_border/meshes.h"

#include <cmath>
#include <string>
#include <utility>

#include "course/halfedge/build.h"
#include "course/mesh/generators.h"
#include "course/runner/suite.h"

namespace course::hidden {

namespace {

Fixture built(std::string name, IndexedMesh mesh) {
    HalfEdgeTable he = build(mesh);
    return {std::move(name), std::move(mesh), std::move(he)};
}

}  // namespace

// fan_with_gap: 18 triangles round vertex 0,      8  5
// from 1 to 19; the gap is between 19 and 1        \ |  2
//   Fi = (0, i+1, i+2), i = 0..17                11-\|/
//   V 20, E 37, F 18, chi 1, 1 loop                  0--- 1
// Nineteen edges meet at 0 (not all are drawn).     /|\ gap
//                                                14  17 19
Fixture fan_with_gap() {
    constexpr int rim = 19;
    IndexedMesh mesh{{{0, 0, 0}}, {}, {}};
    for (int k = 0; k < rim; ++k)
        mesh.positions.push_back(
            {2 * std::cos(0.31 * k), 2 * std::sin(0.31 * k), 0});
    for (int k = 1; k < rim; ++k) mesh.faces.push_back({0, k, k + 1});
    return built("fan with a gap", std::move(mesh));
}

// windows: a wall of 7 x 3 quads,         +--+--+--+--+--+--+--+
// of which three are missing              |  |  |  |  |  |  |  |
//   V 32, E 52, F 18, chi -2, 4 loops     +--+--+--+--+--+--+--+
//                                         |  |##|  |##|  |##|  |
//                                         +--+--+--+--+--+--+--+
//                                         |  |  |  |  |  |  |  |
//                                         +--+--+--+--+--+--+--+
Fixture windows() {
    const IndexedMesh wall = grid(7, 3);
    IndexedMesh mesh{wall.positions, {}, {}};
    for (int f = 0; f < wall.faces.size(); ++f)
        if (f != 8 && f != 10 && f != 12) mesh.faces.push_back(wall.faces[f]);
    return built("windows", std::move(mesh));
}

std::vector<Fixture> generated_borders() {
    std::vector<Fixture> all = generated_fixtures();
    for (std::uint64_t k = 0; k < 4; ++k) {
        RandomMesh options;
        options.faces = 150;
        options.parts = 3;
        options.hole_percent = 20;
        options.surface = k % 2 == 0 ? Surface::open : Surface::mixed;
        options.bow_ties = BowTies::allowed;
        const Fixture fixture =
            built("generated mesh with holes " + std::to_string(k),
                  random_polygons(seed() * 100 + 50 + k, options));
        all.push_back(renumbered(fixture, k));
    }
    return all;
}

}  // namespace course::hidden
