#include "exercises/05_structures/to_soup.h"

Soup to_soup([[maybe_unused]] const IndexedMesh& mesh) {
    // TODO(student): look up the corners of each face.
    return {};
}
