// Lists the triangles from the last to the first.
// Hint: Your triangles are the right ones, but not in the order of the fan.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = fan.size(); k-- > 2;) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
