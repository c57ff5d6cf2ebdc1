// Has a key for each value up to the largest.
// Hint: You have keys for valences that do not occur.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::map<int, int> histogram;
    for (int n : valence)
        for (int k = 0; k <= n; k++) histogram[k] += k == n ? 1 : 0;
    return histogram;
}
