// Treats the border as an error, but a border half-edge has two ends.
// Hint: You refuse a half-edge on the border; it has two ends like any other.
#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {-1, -1};
    return {he[i].vi, he[he[i].next].vi};
}
