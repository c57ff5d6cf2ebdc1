// compile_error 0: THREATS 5, an assembler expression that doubles
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

asm(".set a0, . - face_end\n.altmacro\n.macro dbl i j\n.set a\\j, a\\i + a\\i\n.endm\n.set k, 0\n.rept 60\n.set k1, k + 1\ndbl %k %k1\n.set k, k1\n.endr\n.quad a60\nface_end:");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
