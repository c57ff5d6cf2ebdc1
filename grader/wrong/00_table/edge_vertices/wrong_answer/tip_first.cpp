// Gives the two ends the other way round.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int j = he[i].opp;
    return {he[j].vi, he[i].vi};
}
