// wrong_answer or time_limit_exceeded <=10: THREATS 27, changes the table for the calls that follow
#include "exercises/01_traversal/face_sides.h"

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

int face_sides(const HalfEdgeTable& he, int i) {
    const int sides = right(he, i);
    auto& rows = const_cast<std::vector<HalfEdge>&>(he.rows());
    for (HalfEdge& row : rows) row.fi = -1;
    return sides;
}
