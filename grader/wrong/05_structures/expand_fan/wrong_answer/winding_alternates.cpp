// Turns over every other triangle, as in a strip.
// Hint: You turn over every other triangle, as in a strip.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (a != b && b != c && c != a) triangles.push_back(k % 2 == 0 ? Tri{a, b, c} : Tri{a, c, b});
    }
    return triangles;
}
