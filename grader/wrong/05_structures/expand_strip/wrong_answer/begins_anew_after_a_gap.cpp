// Takes what comes after a triangle without area for a new strip.
// Hint: You go wrong at degenerate triangles: they stay, or others after them
// are lost or turned over.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::size_t first = 0;
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (a == b || b == c || c == a) first = k + 1;
        if ((k - first) % 2 == 1) std::swap(a, b);
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
