#include "exercises/03_building/to_faces.h"

std::vector<std::vector<int>> to_faces(
    [[maybe_unused]] const HalfEdgeTable& he) {
    // TODO(student): walk round each face once, and file it by its number.
    return {};
}
