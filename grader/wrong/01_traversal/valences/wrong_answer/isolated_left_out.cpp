// Leaves the vertices out that no half-edge leaves.
// Hint: You leave out vertices that have no edge.
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::map<int, int> valence;
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::map<int, int> histogram;
    for (auto [v, n] : valence)
        if (v < vertex_count) histogram[n]++;
    return histogram;
}
