// Winged edges for the suites: what stands beside each edge, and structures
// whose edges have any numbers and either direction.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "course/mesh/winged.h"
#include "course/mesh/zoo.h"

namespace course::hidden {

/// What lies along an edge in one direction: the face, and the vertices before
/// the start of the edge and after its tip, round the face or along the border.
struct Side {
    int face = -1;
    int before = -1;
    int after = -1;
};

/// All sides, by start and tip.
using Sides = std::map<std::array<int, 2>, Side>;

/// The sides of faces from the face list, as far as the fixture has one; those
/// along the border from the table, for there the faces may leave a choice.
/// Precondition: no two half-edges run between the same vertices the same way.
Sides sides_of(const Fixture& fixture);

/// The fixture as winged edges, and where its half-edges are in it.
struct WingedFixture {
    WingedMesh mesh;
    std::vector<DirectedEdge> directed;  ///< of each half-edge
};

/// Edges numbered at random, each stored in a random direction, with an edge at
/// random for each vertex and face: from the seed of the run and `salt`.
WingedFixture winged_fixture(const Fixture& fixture, std::uint64_t salt);

}  // namespace course::hidden
