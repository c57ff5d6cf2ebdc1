// Sorts the two ends, so the direction is lost.
// Hint: You have the two ends the wrong way round, at least for some
// half-edges.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int v0 = he[i].vi;
    int v1 = he[he[i].opp].vi;
    if (v0 < v1) return {v0, v1};
    return {v1, v0};
}
