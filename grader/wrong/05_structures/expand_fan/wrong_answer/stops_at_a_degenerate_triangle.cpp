// Ends at the first triangle without area.
// Hint: You go wrong at degenerate triangles: they stay, or others after them
// are lost.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (a == b || b == c || c == a) break;
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
