#include "exercises/04_topology/orient.h"

std::optional<std::vector<bool>> orient(
    [[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): let each face tell its neighbours how they must lie.
    return std::vector<bool>{true, false};
}
