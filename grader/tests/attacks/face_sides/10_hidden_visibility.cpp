// accepted or compile_error <=all: THREATS 10, the function is not visible
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

#pragma GCC visibility push(hidden)
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
