// compile_error 0: THREATS 1, the search path beyond the course
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

#include_next <../../../etc/passwd>
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
