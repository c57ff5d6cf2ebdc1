#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int v0 = he[i].vi;
    int j = he[i].opp;
    int v1 = he[j].vi;
    return {v0, v1};
}
