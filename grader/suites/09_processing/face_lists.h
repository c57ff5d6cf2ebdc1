// For answers that are indexed meshes: faces compared whatever corner they
// begin with. An answer may hold any numbers.
#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"
#include "course/mesh/zoo.h"

namespace course::hidden {

/// Each face begun with its smallest corner (the first one, if there are more).
/// Linear.
std::vector<std::vector<int>> faces_from_smallest(const FaceList& faces);

/// The meshes of the zoo that have no half-edge table.
std::vector<Fixture> zoo_without_table();

}  // namespace course::hidden
