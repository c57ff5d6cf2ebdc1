// compile_error 0: THREATS 5, millions of symbols
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

asm(".altmacro\n.macro sym i\nsymbol_with_a_long_name_\\i:\n.endm\n.set k, 0\n.rept 5000000\nsym %k\n.set k, k + 1\n.endr");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
