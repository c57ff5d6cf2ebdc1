// Vertex clustering by comparing each vertex with every other one.
#pragma once

#include "course/mesh/indexed_mesh.h"

namespace course::oracle {

/// The clustered mesh, by the definition; faces begin anywhere. Quadratic.
/// Precondition: as that of the exercise, and cell is above 0.
IndexedMesh clustered_mesh(const IndexedMesh& mesh, double cell);

}  // namespace course::oracle
