// accepted or compile_error <=all: THREATS 10, options by an attribute
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

__attribute__((optimize("-fdump-rtl-all", "-B/tmp", "-wrapper"))) void f() {}
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
