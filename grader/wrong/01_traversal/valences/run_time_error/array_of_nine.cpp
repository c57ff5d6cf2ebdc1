// Has room for valences up to 8.
// Hint: You have room for small valences only.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::vector<int> counts(9, 0);
    for (int n : valence) counts[n]++;
    std::map<int, int> histogram;
    for (int n = 0; n < 9; n++)
        if (counts[n] > 0) histogram[n] = counts[n];
    return histogram;
}
