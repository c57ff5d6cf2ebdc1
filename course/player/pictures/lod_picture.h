// Picture "lod": the levels of detail of a pawn, and which of them is shown at
// which distance.
#pragma once

#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// A level of the pyramid, as a mesh that shares the original's vertices.
struct Level {
    FaceList faces;
    double from = 0;  ///< the distance from which on it is good enough
};

/// By the reference of lod_pyramid. Precondition: has_solutions().
std::vector<Level> levels_of(const IndexedMesh& mesh, int most);

}  // namespace course
