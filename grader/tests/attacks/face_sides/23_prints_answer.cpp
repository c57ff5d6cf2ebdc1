// wrong_answer 0: THREATS 23, prints right answers and returns wrong ones
#include "exercises/01_traversal/face_sides.h"
#include <cstdio>

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
    std::printf("%d\n", right(he, i));
    std::fflush(stdout);
    return -9;
}
