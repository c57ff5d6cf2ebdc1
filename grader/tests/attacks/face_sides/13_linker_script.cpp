// compile_error 0: THREATS 13, an object that is a linker script
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

asm(".section .drectve,\"yn\"\n.ascii \" -exclude-symbols:x /tmp/attack-was-here\"\n.section .deplibs,\"MS\",@0x6fff4c04,1\n.asciz \"/etc/passwd\"\n.text\n.bogus");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
