// Keeps triangles that have a vertex twice.
// Hint: You go wrong at degenerate triangles: they stay, or others after them
// are lost or turned over.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (k % 2 == 1) std::swap(a, b);
        triangles.push_back({a, b, c});
    }
    return triangles;
}
