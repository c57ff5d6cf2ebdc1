// Walks to a point far away at an angle that hits no corner, as if: it stops too near.
// Hint: You rely on a fixed distance as far away; a polygon may be larger.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    Vec2 far = p + Vec2{2000, 700};
    bool inside = false;
    auto side = [](Vec2 a, Vec2 b, Vec2 c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        if (side(a, b, p) != side(a, b, far) && side(p, far, a) != side(p, far, b))
            inside = !inside;
    }
    return inside;
}
