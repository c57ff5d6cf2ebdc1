#include "exercises/09_processing/clean_mesh.h"

IndexedMesh clean_mesh([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): decide which faces stay, then give the vertices numbers.
    return {{{}}, {}, {}};
}
