// Smoothing, answered from the face list alone: who is next to whom is a set of
// edges, and a border is an edge that is named once.
#pragma once

#include <cstdint>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course::oracle {

/// The positions after `steps` steps, by the definition.
/// Precondition: every corner and every loose end is a vertex of the mesh.
std::vector<Vec3> smoothed(const IndexedMesh& mesh, int steps, double w);

/// Which vertices may move.
std::vector<bool> free_to_move(const IndexedMesh& mesh);

}  // namespace course::oracle

namespace course::hidden {

/// The positions of the mesh, each moved by up to 0.3 in each coordinate.
IndexedMesh roughened(IndexedMesh mesh, std::uint64_t salt = 0);

}  // namespace course::hidden
