// wrong_answer <=3: THREATS 28, a table of walks that never come back
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1) throw std::invalid_argument("no border");
    HalfEdgeTable wrong;
    const int n = he.size() + 2;
    for (int k = 0; k < n; ++k) wrong.push_back({new_vertex, -1, k == border ? n - 1 : n - 1 - k % 2, (k + 1) % n});
    return wrong;
}
