// Gives the index of the opposite half-edge, not the vertex it leaves.
// Hint: You give a half-edge where a vertex was asked for.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    return {he[i].vi, he[i].opp};
}
