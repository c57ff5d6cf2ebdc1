// accepted or compile_error or run_time_error or memory_limit_exceeded <=all: THREATS 5, a thousand giant arrays that are never used
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

template <int n> struct Big { static inline char a[1 << 26]; static char* use() { return Big<n - 1>::use() + (a - a); } };
template <> struct Big<0> { static char* use() { return nullptr; } };
int face_sides(const HalfEdgeTable& he, int i) { return Big<200>::use() == nullptr ? right(he, i) : -9; }
