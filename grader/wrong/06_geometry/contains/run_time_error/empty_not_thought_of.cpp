// Takes the last corner before it asks whether there is one.
// Hint: You read a corner before you ask whether there is one.
#include "exercises/06_geometry/contains.h"

bool contains(std::span<const Vec2> polygon, Vec2 p) {
    bool inside = false;
    Vec2 a = polygon.back();
    for (Vec2 b : polygon) {
        if ((a.y > p.y) != (b.y > p.y) &&
            a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x) > p.x)
            inside = !inside;
        a = b;
    }
    return inside;
}
