// accepted or compile_error <=all: THREATS 13, an object that asks for the plugin of the linker
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

asm(".section .gnu.lto_.symtab.1234,\"e\",@progbits\n.zero 64\n.section .gnu.lto_.opts,\"e\",@progbits\n.ascii \"-fplugin=/tmp/x.so\"\n.byte 0\n.globl __gnu_lto_slim\n.comm __gnu_lto_slim,1,1\n.text");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
