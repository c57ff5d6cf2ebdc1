// Counts a vertex once for each half-edge that leaves it.
// Hint: You count a vertex several times: once for each half-edge that leaves
// it.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::map<int, int> histogram;
    for (int i = 0; i < he.size(); i++) histogram[valence[he[i].vi]]++;
    return histogram;
}
