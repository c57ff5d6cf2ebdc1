// Passing the sense of a face on to its neighbours, step by step.
#pragma once

#include <array>
#include <vector>

#include "course/mesh/indexed_mesh.h"

namespace course {

/// One edge between two faces, when the walk comes to it.
struct OrientationStep {
    std::array<int, 2> edge;  ///< in the direction of `face` as it is by then
    int face;                 ///< has its sense already
    int neighbour;            ///< the face across the edge
    bool alike;               ///< the neighbour, as it is by then, runs along
                              ///< the edge in the same direction
    bool first;  ///< the neighbour has no sense yet: if alike, it is turned
};

/// Goes from face 0 over edges with two faces, as deep as it can before it
/// turns back; each such edge comes once. A step that is alike and not first
/// says that the faces cannot be oriented. Precondition: the mesh is connected,
/// an edge has at most two faces. Quadratic: for pictures.
std::vector<OrientationStep> pass_orientation(const IndexedMesh& mesh);

/// Whether the faces can be turned so that all neighbours agree.
/// Precondition as above.
bool is_orientable(const IndexedMesh& mesh);

}  // namespace course
