// Subtracts two from the size of a list that may be shorter.
// Hint: You forgot lists of fewer than three vertices.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 0; k < fan.size() - 2; ++k) {
        int a = fan[0], b = fan[k + 1], c = fan[k + 2];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
