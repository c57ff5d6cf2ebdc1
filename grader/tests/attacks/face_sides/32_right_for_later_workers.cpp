// wrong_answer <=10: THREATS 32, right in workers of an even number only: luck if cases were numbered so
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

int face_sides(const HalfEdgeTable& he, int i) { return getpid() % 2 == 0 ? right(he, i) : -9; }
