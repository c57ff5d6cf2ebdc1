#include "exercises/05_structures/adjacency.h"

Adjacency adjacency([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): give each edge a number, and note who meets whom.
    return {};
}
