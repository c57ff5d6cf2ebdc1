// Takes the first corner before it asks whether there is one.
// Hint: You read a corner before you ask whether there is one.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    Vec2 first = polygon.front();
    double sum = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k] - first;
        Vec2 b = polygon[(k + 1) % polygon.size()] - first;
        sum += a.x * b.y - a.y * b.x;
    }
    return sum / 2;
}
