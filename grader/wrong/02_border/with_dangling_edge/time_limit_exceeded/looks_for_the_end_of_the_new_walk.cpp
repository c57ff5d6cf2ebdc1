// Checks its own result by a walk that can never come back to its start.
// Hint: You wait for a start that your walk never meets.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    int tip = he[he[border].opp].vi;
    HalfEdgeTable longer = he;
    longer.push_back({tip, -1, out + 1, out + 1});
    longer.push_back({new_vertex, -1, he[border].next, out});
    longer[border].next = out;
    int i = out;
    while (i != he[border].opp) i = longer[i].next;
    return longer;
}
