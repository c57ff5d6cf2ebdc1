// Takes the last vertex for the common one.
// Hint: Your triangles meet at a vertex that is not the first of the list.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); ++k) {
        int a = fan.back(), b = fan[k - 2], c = fan[k - 1];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
