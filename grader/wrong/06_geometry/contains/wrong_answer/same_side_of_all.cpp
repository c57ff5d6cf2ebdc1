// Asks whether p is on the same side of all sides: right for convex polygons.
// Hint: You are right for convex polygons only.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool left = false;
    bool right = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 d = polygon[(k + 1) % polygon.size()] - polygon[k];
        Vec2 w = p - polygon[k];
        double side = d.x * w.y - d.y * w.x;
        left = left || side > 0;
        right = right || side < 0;
    }
    return left != right;
}
