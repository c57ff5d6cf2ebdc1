// Walks on until it meets a half-edge that is its own opposite: there is none.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[j].opp != j) j = he[j].next;
    return {he[i].vi, he[j].vi};
}
