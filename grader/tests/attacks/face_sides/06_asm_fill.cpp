// compile_error 0: THREATS 6, the assembler fills gigabytes
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

asm(".data\n.fill 4000000000, 1, 7\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
