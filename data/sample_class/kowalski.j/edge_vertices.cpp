#include "exercises/00_table/edge_vertices.h"

std::array<int, 2> edge_vertices(const HalfEdgeTable& he, int i) {
    int a = he[i].vi;
    int b = he[he[i].next].vi;
    return {a, b};
}
