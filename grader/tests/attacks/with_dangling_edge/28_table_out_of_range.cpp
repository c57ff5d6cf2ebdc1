// wrong_answer <=3: THREATS 28, a table whose indices lead out of it, of the right size
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1) throw std::invalid_argument("no border");
    HalfEdgeTable wrong;
    for (int k = 0; k < he.size() + 2; ++k)
        wrong.push_back({new_vertex + k, -1, k % 2 == 0 ? 2147483647 : -2147483647, k % 3 == 0 ? -1 : 1 << 30});
    return wrong;
}
