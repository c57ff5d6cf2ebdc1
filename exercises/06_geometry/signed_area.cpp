#include "exercises/06_geometry/signed_area.h"

double signed_area([[maybe_unused]] std::span<const Vec2> polygon) {
    // TODO(student): add up what each side contributes, with its sign.
    return -1e9;
}
