// Crosses to the border when given the side of a face: that is an error.
// Hint: You accept a half-edge that has a face.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size())
        throw std::invalid_argument("no such half-edge");
    if (he[border].fi != -1) border = he[border].opp;
    if (he[border].fi != -1) throw std::invalid_argument("not on a border");
    int out = he.size();
    int tip = he[he[border].opp].vi;
    HalfEdgeTable longer = he;
    longer.push_back({tip, -1, out + 1, out + 1});
    longer.push_back({new_vertex, -1, he[border].next, out});
    longer[border].next = out;
    return longer;
}
