// Takes only a positive winding number for inside: right for counter-clockwise polygons.
// Hint: You are right for polygons that go round in one direction only.
#include "exercises/06_geometry/contains.h"

#include <cmath>

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    double angle = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        Vec2 a = polygon[k] - p;
        Vec2 b = polygon[(k + 1) % polygon.size()] - p;
        angle += std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y);
    }
    return angle > 1;
}
