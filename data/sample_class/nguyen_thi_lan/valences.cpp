#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::vector<int> val;                       // forgot the size
    for (int i = 0; i < he.size(); i++) val[he[i].vi]++;
    std::map<int, int> m;
    for (int v = 0; v < vertex_count; v++) m[val[v]]++;
    return m;
}
