// memory_limit_exceeded or wrong_answer <=3: THREATS 28, a table of a million rows
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1) throw std::invalid_argument("no border");
    return HalfEdgeTable(std::vector<HalfEdge>(1'000'000, HalfEdge{new_vertex, 0, 0, 0}));
}
