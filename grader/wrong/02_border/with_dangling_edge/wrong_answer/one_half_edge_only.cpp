// Appends a single half-edge that is its own opposite.
// Hint: You append one half-edge; an edge has two.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    HalfEdgeTable longer = he;
    longer.push_back({new_vertex, -1, he[border].next, out});
    longer[border].next = out;
    return longer;
}
