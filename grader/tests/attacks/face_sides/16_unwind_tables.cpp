// accepted or compile_error or run_time_error <=all: THREATS 16, broken tables for exceptions
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

asm(".section .eh_frame,\"a\"\n.long 0xffffff00\n.long 7\n.long -1\n.text");
int face_sides(const HalfEdgeTable& he, int i) {
    try {
        throw 1;
    } catch (int) {
    }
    return right(he, i);
}
