// compile_error 0: THREATS 7, a message of megabytes
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

#define A "stop stop stop stop stop stop stop stop stop stop stop stop stop stop "
#define B A A A A A A A A A A A A A A A A A A A A A A A A A A A A A A
#define C B B B B B B B B B B B B B B B B B B B B B B B B B B B B B B
#define D C C C C C C C C C C C C C C C C C C C C C C C C C C C C C C
static_assert(false, D);
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
