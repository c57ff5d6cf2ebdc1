// time_limit_exceeded 0: THREATS 33, waits for nothing
#include "exercises/01_traversal/face_sides.h"
#include <poll.h>

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
    while (true) poll(nullptr, 0, -1);
    return right(he, i);
}
