// time_limit_exceeded 0: THREATS 21, stops and waits to be woken
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

int face_sides(const HalfEdgeTable& he, int i) {
    raise(SIGSTOP);
    return right(he, i);
}
