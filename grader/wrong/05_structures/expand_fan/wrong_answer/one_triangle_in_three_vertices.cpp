// Takes the list for a list of triangles.
// Hint: You use each vertex of the list for one triangle only.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); k += 3) {
        int a = fan[k - 2], b = fan[k - 1], c = fan[k];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
