// Gives the two ends the other way round.
// Hint: You have the two ends the wrong way round, at least for some
// half-edges.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    return {he[j].vi, he[i].vi};
}
