// Takes the sign from the first corner, which may be a reflex one.
// Hint: You get the sign wrong where a polygon is not convex: one corner does
// not tell it.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double twice_area = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        Vec2 a = polygon[k - 1] - polygon[0];
        Vec2 b = polygon[k] - polygon[0];
        twice_area += a.x * b.y - a.y * b.x;
    }
    if (polygon.size() < 3) return 0;
    Vec2 a = polygon[1] - polygon[0];
    Vec2 b = polygon[2] - polygon[1];
    double size = twice_area < 0 ? -twice_area / 2 : twice_area / 2;
    return a.x * b.y - a.y * b.x < 0 ? -size : size;
}
