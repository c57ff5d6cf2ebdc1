// Reads a corner after the last.
// Hint: You read a corner after the last one.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k] - polygon[0];
        Vec2 b = polygon[k + 1] - polygon[0];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}
