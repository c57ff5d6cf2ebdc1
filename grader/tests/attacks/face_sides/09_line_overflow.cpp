// accepted all: THREATS 9, line numbers at the edge of int
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

#line 2147483646 "x"
int a;
int b;
int c;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
