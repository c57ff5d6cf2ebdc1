// compile_error 0: THREATS 53, what the compiler of another submission left
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

#include "/tmp/s.o"
#include "/tmp/s.so"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
