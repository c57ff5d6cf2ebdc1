// Counts the first end of a side but not the second, whichever is the lower.
// Hint: You go wrong where the way from the point passes through a corner of
// the polygon.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        // A corner at the height of p counts as below it.
        bool up = a.y <= p.y && p.y < b.y;
        bool down = a.y >= p.y && p.y > b.y;
        if (!up && !down) continue;
        double t = (p.y - a.y) / (b.y - a.y);
        if (a.x + t * (b.x - a.x) > p.x) inside = !inside;
    }
    return inside;
}
