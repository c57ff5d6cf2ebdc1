// Turns over the wrong half of the triangles.
// Hint: You wind the triangles the wrong way round.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (k % 2 == 0) std::swap(a, b);
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
