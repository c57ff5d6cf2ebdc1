// Adds a triangle from the last vertex to the second.
// Hint: You close the fan: its last triangle is one too many.
#include "exercises/05_structures/expand_fan.h"

std::vector<Tri> expand_fan(const std::vector<int>& fan) {
    std::vector<Tri> triangles;
    for (std::size_t k = 2; fan.size() > 2 && k <= fan.size(); ++k) {
        int a = fan[0], b = fan[k - 1], c = k < fan.size() ? fan[k] : fan[1];
        if (a != b && b != c && c != a) triangles.push_back({a, b, c});
    }
    return triangles;
}
