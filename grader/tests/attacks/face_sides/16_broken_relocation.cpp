// accepted or compile_error or run_time_error <=all: THREATS 16, a relocation that writes where it should not
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

asm(".section .rodata\n.reloc ., R_X86_64_64, getpid + 0x7fffffff\n.quad 0\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
