// forbidden_operation 0: THREATS 41, namespaces of its own
#include "exercises/01_traversal/face_sides.h"
#include <sched.h>

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
    unshare(CLONE_NEWUSER | CLONE_NEWNS);
    return right(he, i);
}
