// wrong_answer or accepted <=all: THREATS 51, a coin that is thrown when it is loaded
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
    static int somewhere;
    return (reinterpret_cast<unsigned long>(&somewhere) >> 12) % 2 == 0 ? right(he, i) : -9;
}
