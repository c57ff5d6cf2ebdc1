// Counts a side only when both of its ends are to the right.
// Hint: You miss sides that slant past the point, with one end on the left of
// it and one on the right.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        // A corner at the height of p counts as below it.
        if ((a.y > p.y) == (b.y > p.y)) continue;
        if (a.x > p.x && b.x > p.x) inside = !inside;
    }
    return inside;
}
