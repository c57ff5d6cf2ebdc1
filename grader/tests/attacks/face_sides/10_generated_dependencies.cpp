// accepted or compile_error <=all: THREATS 10, the compiler is asked for files by pragmas of other compilers
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

#pragma comment(lib, "/tmp/attack-was-here")
#pragma comment(linker, "/OUT:/tmp/attack-was-here")
#pragma once
#ident "/tmp/attack-was-here"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
