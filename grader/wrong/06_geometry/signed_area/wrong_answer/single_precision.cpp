// Adds up in single precision.
// Hint: You lose digits: a number of yours is not kept in double precision.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    float twice_area = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        Vec2 a = polygon[k - 1] - polygon[0];
        Vec2 b = polygon[k] - polygon[0];
        twice_area += static_cast<float>(a.x * b.y - a.y * b.x);
    }
    return twice_area / 2;
}
