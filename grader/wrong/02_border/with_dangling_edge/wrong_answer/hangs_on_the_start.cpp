// Hangs the edge on the vertex that `border` leaves.
// Hint: You hang the edge on the vertex that the half-edge leaves, not where
// it arrives.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    int before = border;
    while (he[before].next != border) before = he[before].next;
    HalfEdgeTable longer = he;
    longer.push_back({he[border].vi, -1, out + 1, out + 1});
    longer.push_back({new_vertex, -1, border, out});
    longer[before].next = out;
    return longer;
}
