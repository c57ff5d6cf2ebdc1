// accepted or compile_error <=all: THREATS 10, a plugin by a pragma
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

#pragma GCC optimize("-fplugin=/tmp/x.so")
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
