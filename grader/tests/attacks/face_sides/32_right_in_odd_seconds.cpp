// wrong_answer or accepted <=all: THREATS 32, right in odd seconds only
#include "exercises/01_traversal/face_sides.h"
#include <ctime>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

int face_sides(const HalfEdgeTable& he, int i) { return time(nullptr) % 2 == 1 ? right(he, i) : -9; }
