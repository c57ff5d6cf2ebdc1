#include "exercises/03_building/defects.h"

std::vector<MeshDefect> defects([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): look at each face, then at each edge, then at each vertex.
    return {{MeshFault::too_few_corners, {-1}}};
}
