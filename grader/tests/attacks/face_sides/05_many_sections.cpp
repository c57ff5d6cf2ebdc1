// compile_error 0: THREATS 5, half a million sections
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

asm(".altmacro\n.macro sec i\n.section .s\\i,\"a\"\n.byte 1\n.endm\n.set k, 0\n.rept 500000\nsec %k\n.set k, k + 1\n.endr\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
