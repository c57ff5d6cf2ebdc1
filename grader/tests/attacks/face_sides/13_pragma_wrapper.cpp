// accepted or compile_error <=all: THREATS 13, a program by an option of the compiler
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

#pragma GCC optimize("-wrapper /bin/sh,-c,id")
#pragma GCC target("arch=native;id")
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
