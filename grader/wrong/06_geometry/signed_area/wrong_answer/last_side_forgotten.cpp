// Forgets the side from the last corner to the first: right when corner 0 is the origin.
// Hint: You forget the side from the last corner to the first.
#include "exercises/06_geometry/signed_area.h"

double signed_area(std::span<const Vec2> polygon) {
    double sum = 0;
    for (std::size_t k = 1; k < polygon.size(); ++k)
        sum += polygon[k - 1].x * polygon[k].y - polygon[k - 1].y * polygon[k].x;
    return polygon.size() < 3 ? 0 : sum / 2;
}
