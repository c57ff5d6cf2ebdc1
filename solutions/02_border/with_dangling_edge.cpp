#include "exercises/02_border/with_dangling_edge.h"

#include <string>

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border,
                                 int new_vertex) {
    if (border < 0 || border >= he.size())
        throw std::invalid_argument("half-edge " + std::to_string(border) +
                                    ": the table has 0.." +
                                    std::to_string(he.size() - 1));
    if (he[border].fi != -1)
        throw std::invalid_argument("half-edge " + std::to_string(border) +
                                    ": fi is " + std::to_string(he[border].fi) +
                                    ", but on a border it is -1");

    int out = he.size();
    int back = out + 1;
    int tip = he[he[border].opp].vi;

    HalfEdgeTable longer = he;
    longer.push_back({tip, -1, back, back});
    longer.push_back({new_vertex, -1, he[border].next, out});
    longer[border].next = out;
    return longer;
}
