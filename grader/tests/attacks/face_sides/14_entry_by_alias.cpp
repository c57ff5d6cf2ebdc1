// compile_error 0: THREATS 14, the entry is an alias in a section of its own
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

asm(".globl course_entry\n.set course_entry, _Z10face_sidesRKN13checked_table13HalfEdgeTableEi");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
