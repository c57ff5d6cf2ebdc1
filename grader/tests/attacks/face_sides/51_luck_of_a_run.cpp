// wrong_answer or accepted <=all: THREATS 51, a coin that is thrown when it is compiled
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

static constexpr int coin = __TIME__[7] % 2;
int face_sides(const HalfEdgeTable& he, int i) { return coin == 1 ? right(he, i) : -9; }
