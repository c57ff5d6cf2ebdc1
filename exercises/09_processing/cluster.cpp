#include "exercises/09_processing/cluster.h"

IndexedMesh cluster([[maybe_unused]] const IndexedMesh& mesh,
                    [[maybe_unused]] double cell) {
    // TODO(student): let one vertex stand for all those in the same cube.
    return {};
}
