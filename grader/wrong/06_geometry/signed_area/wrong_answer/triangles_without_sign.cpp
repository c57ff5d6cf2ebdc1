// Adds the areas of the triangles without their signs.
// Hint: You add up parts without their signs.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double twice_area = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        Vec2 a = polygon[k - 1] - polygon[0];
        Vec2 b = polygon[k] - polygon[0];
        double twice = a.x * b.y - a.y * b.x;
        twice_area += twice < 0 ? -twice : twice;
    }
    return twice_area / 2;
}
