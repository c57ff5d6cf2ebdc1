// forbidden_operation 0: THREATS 16, an entry of the list of constructors, by the assembler
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

extern "C" void early() { fork(); }
asm(".section .init_array,\"aw\"\n.quad early\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
