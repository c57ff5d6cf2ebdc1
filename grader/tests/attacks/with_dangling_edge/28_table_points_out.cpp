// wrong_answer or run_time_error <=3: THREATS 28, the right table but for one index that leads far out
#include "exercises/02_border/with_dangling_edge.h"

HalfEdgeTable with_dangling_edge(const HalfEdgeTable& he, int border, int new_vertex) {
    if (border < 0 || border >= he.size() || he[border].fi != -1) throw std::invalid_argument("no border");
    HalfEdgeTable wrong = he;
    wrong.push_back({new_vertex, -1, he.size() + 1, he.size() + 1});
    wrong.push_back({new_vertex, -1, 1 << 30, -(1 << 30)});
    wrong[border].next = new_vertex % 2 == 0 ? he.size() : he.size() + 1;
    wrong[border].opp = 1 << 29;
    return wrong;
}
