#include "exercises/03_building/edges.h"

std::vector<EdgeInfo> edges([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): two sides between the same vertices are one edge.
    return {};
}
