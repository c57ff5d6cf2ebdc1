#include "exercises/08_making/triangulate.h"

std::vector<std::array<int, 3>> triangulate(
    [[maybe_unused]] std::span<const Vec3> polygon) {
    // TODO(student): find an ear, cut it off, and go on with what is left.
    return {{-1, -1, -1}};
}
