// compile_error 0: THREATS 1, the reference by its real path, as the own answer
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

#include "@ROOT@/solutions/01_traversal/face_sides.cpp"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
