// accepted or compile_error or run_time_error <=all: THREATS 20, an executable stack
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

asm(".section .note.GNU-stack,\"x\",@progbits\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
