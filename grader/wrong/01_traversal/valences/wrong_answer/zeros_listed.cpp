// Has a key for values that do not occur.
// Hint: You have keys for valences that do not occur.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::map<int, int> histogram;
    histogram[0] = 0;
    for (int n : valence) histogram[n]++;
    return histogram;
}
