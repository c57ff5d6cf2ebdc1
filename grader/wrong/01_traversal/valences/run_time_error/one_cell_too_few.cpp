// Has no cell for the last vertex.
#include "exercises/01_traversal/valences.h"

#include <algorithm>
#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(std::max(vertex_count - 1, 0), 0);
    for (int i = 0; i < he.size(); i++) valence[he[i].vi]++;

    std::map<int, int> histogram;
    for (int n : valence) histogram[n]++;
    return histogram;
}
