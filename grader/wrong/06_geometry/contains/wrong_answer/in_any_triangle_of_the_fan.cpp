// Cuts the polygon into triangles at corner 0, and asks whether p is in any.
// Hint: You cut the polygon into triangles that may lie outside of it.
#include "exercises/06_geometry/contains.h"

namespace {

double side(Vec2 a, Vec2 b, Vec2 p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

}  // namespace

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        double u = side(polygon[0], polygon[k - 1], p);
        double v = side(polygon[k - 1], polygon[k], p);
        double w = side(polygon[k], polygon[0], p);
        if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
            return true;
    }
    return false;
}
