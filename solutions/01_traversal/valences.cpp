#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> valence(static_cast<std::size_t>(vertex_count), 0);
    for (int i = 0; i < he.size(); ++i)
        ++valence[static_cast<std::size_t>(he[i].vi)];
    std::map<int, int> histogram;
    for (int edges : valence) ++histogram[edges];
    return histogram;
}
