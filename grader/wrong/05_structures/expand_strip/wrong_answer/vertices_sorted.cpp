// Sorts the vertices of each triangle.
// Hint: How you wind a triangle depends on the numbers of its vertices; they
// mean nothing.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < strip.size(); ++k) {
        int a = strip[k], b = strip[k + 1], c = strip[k + 2];
        if (k % 2 == 1) std::swap(a, b);
        if (a != b && b != c && c != a) {
            Tri t = {a, b, c};
            std::sort(t.begin(), t.end());
            triangles.push_back(t);
        }
    }
    return triangles;
}
