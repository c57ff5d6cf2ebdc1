// Counts clockwise as positive.
// Hint: You count clockwise as positive.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double twice_area = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        Vec2 a = polygon[k - 1] - polygon[0];
        Vec2 b = polygon[k] - polygon[0];
        twice_area += a.y * b.x - a.x * b.y;
    }
    return twice_area / 2;
}
