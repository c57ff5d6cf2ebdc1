#include "exercises/05_structures/weld.h"

IndexedMesh weld([[maybe_unused]] std::span<const SoupTriangle> soup,
                 [[maybe_unused]] double eps) {
    // TODO(student): find for each corner its vertex, or make one.
    return {};
}
