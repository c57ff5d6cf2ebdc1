// time_limit_exceeded 0: THREATS 15, sleeps for ever when it is loaded
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

struct Sleep { Sleep() { for (;;) sleep(100); } } sleeping;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
