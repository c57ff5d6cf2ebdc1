// Winds all triangles the other way round.
// Hint: You wind the triangles the wrong way round.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (a != b && b != c && c != a) triangles.push_back({a, c, b});
    }
    return triangles;
}
