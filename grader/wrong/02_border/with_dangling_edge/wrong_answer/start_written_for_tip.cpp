// Links the rows rightly, but writes the start of `border` as its tip.
// Hint: You link the new edge rightly, but let it leave the wrong vertex.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    HalfEdgeTable longer = he;
    longer.push_back({he[border].vi, -1, out + 1, out + 1});
    longer.push_back({new_vertex, -1, he[border].next, out});
    longer[border].next = out;
    return longer;
}
