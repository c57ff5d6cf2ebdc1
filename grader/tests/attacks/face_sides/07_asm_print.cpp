// compile_error or accepted 0: THREATS 7, the assembler prints without an end
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

asm(".rept 1000000\n.rept 1000000\n.print \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\"\n.endr\n.endr");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
