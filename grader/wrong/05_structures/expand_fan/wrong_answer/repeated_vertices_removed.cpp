// Removes every vertex that it has seen already: closed fans stay open.
// Hint: You leave out a vertex that was there before; a fan may come back to
// it.
#include "exercises/05_structures/expand_fan.h"

#include <set>

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::set<int> seen;
    std::vector<Tri> triangles;
    for (std::size_t k = 2; k < fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = fan[k];
        if (k == 2) seen = {a, b};
        if (!seen.insert(c).second) continue;
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
