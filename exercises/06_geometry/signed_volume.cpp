#include "exercises/06_geometry/signed_volume.h"

double signed_volume([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): add up what each face has to say about the inside.
    return -1;
}
