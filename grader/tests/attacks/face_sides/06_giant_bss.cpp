// compile_error or run_time_error or memory_limit_exceeded 0: THREATS 6, a variable larger than the limit of memory
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

char big[1L << 30];
int face_sides(const HalfEdgeTable& he, int i) { return big[i] + right(he, i); }
