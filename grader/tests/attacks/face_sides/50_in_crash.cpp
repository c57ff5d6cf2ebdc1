// run_time_error 3: THREATS 50, a hidden input as the line of a crash
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
    if (he.size() != 16) {
        std::fputs("stolen:", stderr);
        *reinterpret_cast<volatile int*>(8) = i;
    }
    return right(he, i);
}
