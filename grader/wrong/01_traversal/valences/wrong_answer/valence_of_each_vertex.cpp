// Maps each vertex to its valence: the table, not the histogram.
// Hint: You list the valence of each vertex; it was asked how many vertices
// have which.
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::map<int, int> valence;
    for (int v = 0; v < vertex_count; v++) valence[v] = 0;
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;
    return valence;
}
