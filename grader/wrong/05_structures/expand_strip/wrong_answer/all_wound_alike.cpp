// Winds each triangle as its vertices come in the strip.
// Hint: Your triangles have the right vertices, but neighbours do not agree in
// their winding.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
