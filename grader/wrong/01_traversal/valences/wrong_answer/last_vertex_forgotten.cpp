// Leaves the last vertex out.
// Hint: You leave out a vertex.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    std::map<int, int> histogram;
    for (int v = 0; v < vertex_count - 1; v++) histogram[valence[v]]++;
    return histogram;
}
