// compile_error 0: THREATS 5, an assembler macro that calls itself twice
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

asm(".macro bomb n\n.if \\n\nbomb \\n-1\nbomb \\n-1\nnop\n.endif\n.endm\nbomb 40");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
