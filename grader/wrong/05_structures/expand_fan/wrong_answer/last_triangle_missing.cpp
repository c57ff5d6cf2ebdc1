// Ends one triangle early.
// Hint: You leave out the last triangle.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k + 1 < fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
