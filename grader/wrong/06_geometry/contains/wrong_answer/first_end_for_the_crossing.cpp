// Compares with the first end of the side, not with the point where it is crossed.
// Hint: You ask where a side begins, and not where it passes the point.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        // A corner at the height of p counts as below it.
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (a.x > p.x) inside = !inside;
    }
    return inside;
}
