// time_limit_exceeded 10: THREATS 27, the same with all that the processor can do
#include "exercises/01_traversal/face_sides.h"

#pragma GCC optimize("O3,unroll-loops")
#pragma GCC target("avx2")
static int scan(const HalfEdge* row, std::size_t n, int face) {
    int sides = 0;
    for (std::size_t k = 0; k < n; ++k) sides += row[k].fi == face ? 1 : 0;
    return sides;
}
int face_sides(const HalfEdgeTable& he, int i) {
    const HalfEdge* rows = *reinterpret_cast<const HalfEdge* const*>(&he.rows());
    const int face = rows[i].fi;
    return face == -1 ? 0 : scan(rows, static_cast<std::size_t>(he.size()), face);
}
