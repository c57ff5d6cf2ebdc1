// Subtracts two from the size of a list that may be shorter.
// Hint: You forgot lists of fewer than three vertices.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k < strip.size() - 2; ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (k % 2 == 1) std::swap(a, b);
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
