// Lists the triangles from the last to the first.
// Hint: Your triangles are the right ones, but not in the order of the strip.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (k % 2 == 1) std::swap(a, b);
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    std::reverse(triangles.begin(), triangles.end());
    return triangles;
}
