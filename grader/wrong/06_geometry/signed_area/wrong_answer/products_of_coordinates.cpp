// Multiplies the coordinates themselves: far from the origin nothing is left of the area.
// Hint: You lose digits: numbers cancel out that grow with the distance from
// the origin.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k];
        Vec2 b = polygon[(k + 1) % polygon.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}
