// Makes one vertex of two equal ones in a row, and so loses count.
// Hint: You go wrong at degenerate triangles: they stay, or others after them
// are lost or turned over.
#include "exercises/05_structures/expand_strip.h"

#include <algorithm>
#include <utility>

std::vector<Tri> expand_strip(const std::vector<int>& strip) {
    std::vector<int> list = strip;
    list.erase(std::unique(list.begin(), list.end()), list.end());
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k + 2 < list.size(); ++k) {
        int a = list[k], b = list[k + 1], c = list[k + 2];
        if (k % 2 == 1) std::swap(a, b);
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
