// Counts the faces at each vertex, not the edges.
// Hint: You count the faces at a vertex, not its edges.
#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(vertex_count, 0);
    for (int i = 0; i < he.size(); i++)
        if (he[i].fi != -1) valence[he[i].vi]++;

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
