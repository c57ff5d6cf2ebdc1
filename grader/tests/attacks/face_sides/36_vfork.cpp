// forbidden_operation 0: THREATS 36, a process that shares its memory
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

int face_sides(const HalfEdgeTable& he, int i) {
    if (vfork() == 0) _exit(0);
    return right(he, i);
}
