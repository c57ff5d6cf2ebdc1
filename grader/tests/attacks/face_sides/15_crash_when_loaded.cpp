// run_time_error 0: THREATS 15, a null pointer when it is loaded
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

volatile int* nothing = nullptr;
int crash = *nothing;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
