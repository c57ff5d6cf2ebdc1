// compile_error or run_time_error 0: THREATS 6, an alignment of a gigabyte
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

asm(".data\n.balign 1073741824\nx: .byte 1\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
