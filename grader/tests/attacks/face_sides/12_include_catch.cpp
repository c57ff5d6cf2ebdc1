// accepted all: THREATS 12, the library of the suites is a system header, and does nothing here
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

#include <catch2/catch.hpp>
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
