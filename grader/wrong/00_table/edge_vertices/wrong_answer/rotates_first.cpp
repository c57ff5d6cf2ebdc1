// Goes on round the vertex before it reads the tip: opp, next, opp.
// Hint: You look for the other end at another edge of the vertex.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int j = he[he[i].opp].next;
    return {he[i].vi, he[he[j].opp].vi};
}
