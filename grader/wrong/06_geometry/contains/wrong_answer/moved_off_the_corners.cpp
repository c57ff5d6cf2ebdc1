// Moves p up a little, so that it is at the height of no corner: by too much, or too little.
// Hint: You ask for another point than the one that is given: what is little
// in one polygon is much in another.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    p.y += 1e-3;
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        if ((a.y - p.y) * (b.y - p.y) >= 0) continue;
        if (a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x)
            inside = !inside;
    }
    return inside;
}
