// Takes the first vertex for each triangle, as in a fan.
// Hint: You take the same first vertex for all triangles, as in a fan.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[0], b = strip[k + 1], c = strip[k + 2];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
