// compile_error 0: THREATS 5, a tree of includes 190 levels deep
#include "exercises/01_traversal/face_sides.h"

#if __INCLUDE_LEVEL__ < 190
#include "face_sides.cpp"
#include "face_sides.cpp"
#else
#endif
#if __INCLUDE_LEVEL__ == 0

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
#endif
