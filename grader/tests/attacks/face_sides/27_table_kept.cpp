// wrong_answer <=10: THREATS 27, keeps a pointer to the table of the first call
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
    static const HalfEdgeTable* first = &he;
    return i < first->size() ? right(*first, i) : -9;
}
