// Asks whether p is in the box round the polygon.
// Hint: You ask for the box round the polygon; not all of it is inside.
#include "exercises/06_geometry/contains.h"

#include <algorithm>

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    if (polygon.size() < 3) return false;
    Vec2 least = polygon[0];
    Vec2 most = polygon[0];
    for (Vec2 c : polygon) {
        least = {std::min(least.x, c.x), std::min(least.y, c.y)};
        most = {std::max(most.x, c.x), std::max(most.y, c.y)};
    }
    return least.x < p.x && p.x < most.x && least.y < p.y && p.y < most.y;
}
