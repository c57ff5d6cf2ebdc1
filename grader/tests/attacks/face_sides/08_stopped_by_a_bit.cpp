// compile_error 0: THREATS 8, static_assert as an oracle of one bit
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

static_assert(__TIME__[7] == 0, "the second of compiling is odd");
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
