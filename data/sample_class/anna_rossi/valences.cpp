#include "exercises/01_traversal/valences.h"

#include <vector>

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count)
{
    std::map<int, int> istogramma;
    std::vector<int> valenza(vertex_count);
    for (const HalfEdge& h : he) valenza[h.vi]++;
    for (int v = 0; v < vertex_count; v++) istogramma[valenza[v]]++;
    return istogramma;
}
