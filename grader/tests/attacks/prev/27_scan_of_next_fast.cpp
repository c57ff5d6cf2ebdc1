// time_limit_exceeded or run_time_error <=10: THREATS 27, a scan of a million rows, as fast as the processor can
#include "exercises/00_table/prev.h"

#pragma GCC optimize("O3,unroll-loops")
#pragma GCC target("avx2")
int prev(const HalfEdgeTable& he, int i) {
    const HalfEdge* rows = *reinterpret_cast<const HalfEdge* const*>(&he.rows());
    const int n = he.size();
    // Most of the half-edges before lie near.
    for (int k = 0; k < n; ++k)
        if (rows[k].next == i) return k;
    return -1;
}
