#include "exercises/09_processing/hausdorff.h"

double hausdorff([[maybe_unused]] const IndexedMesh& a,
                 [[maybe_unused]] const IndexedMesh& b) {
    // TODO(student): find the vertex that is farthest from the other surface.
    return -1;
}
