// Gives the new half-edges the face across from `border`.
// Hint: You give the new edge a face.
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1)
        throw std::invalid_argument("not on a border");
    int out = he.size();
    int j = he[border].opp;
    HalfEdgeTable longer = he;
    longer.push_back({he[j].vi, he[j].fi, out + 1, out + 1});
    longer.push_back({new_vertex, he[j].fi, he[border].next, out});
    longer[border].next = out;
    return longer;
}
