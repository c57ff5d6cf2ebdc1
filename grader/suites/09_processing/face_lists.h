// For answers that are indexed meshes: faces compared whatever corner they
// begin with. An answer may hold any numbers.
#pragma once

#include <cstdint>
#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "course/mesh/zoo.h"

namespace course::hidden {

/// Each face begun with its smallest corner (the first one, if there are more).
/// Linear.
std::vector<std::vector<int>> faces_from_smallest(const FaceList& faces);

/// The same mesh with vertices and faces in another order, and faces that begin
/// elsewhere; from the seed of the run and `salt`. It needs no table.
IndexedMesh shuffled(const IndexedMesh& mesh, std::uint64_t salt);

/// The meshes of the zoo that have no half-edge table.
std::vector<Fixture> zoo_without_table();

}  // namespace course::hidden
