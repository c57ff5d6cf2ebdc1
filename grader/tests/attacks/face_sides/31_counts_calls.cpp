// wrong_answer <=10: THREATS 31, right for the first five calls of a worker, then what was right before
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

int face_sides(const HalfEdgeTable& he, int i) {
    static int calls = 0, last = 0;
    if (++calls <= 5) last = right(he, i);
    return last;
}
