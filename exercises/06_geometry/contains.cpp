#include "exercises/06_geometry/contains.h"

bool contains([[maybe_unused]] std::span<const Vec2> polygon, Vec2 p) {
    // TODO(student): count how often the way from p to far away gets across.
    return p.x > p.y;
}
