// Reads the next of `border` after it was changed: the way back loops.
// Hint: From the new edge, you do not lead back to where the walk went before.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    int tip = he[he[border].opp].vi;
    HalfEdgeTable longer = he;
    longer[border].next = out;
    longer.push_back({tip, -1, out + 1, out + 1});
    longer.push_back({new_vertex, -1, longer[border].next, out});
    return longer;
}
