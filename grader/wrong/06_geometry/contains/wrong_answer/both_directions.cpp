// Counts the sides on both sides of p.
// Hint: You count sides on both sides of the point.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        // A corner at the height of p counts as below it.
        if ((a.y > p.y) == (b.y > p.y)) continue;
        inside = !inside;
    }
    return inside;
}
