// accepted or compile_error <=all: THREATS 13, debug entries that name files of the machine
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

asm(".file 1 \"/etc/passwd\"\n.loc 1 1\n.ident \"x\"\n.weakref a, b");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
