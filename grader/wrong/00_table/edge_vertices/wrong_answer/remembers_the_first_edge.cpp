// A static variable keeps the tip of the first call for all later ones.
// Hint: Something of yours keeps its value from one call to the next.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    static int v1 = he[he[i].opp].vi;
    return {he[i].vi, v1};
}
