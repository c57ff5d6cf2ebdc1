// memory_limit_exceeded 0: THREATS 37, memory without an end
#include "exercises/01_traversal/face_sides.h"
#include <cstdlib>

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
    while (true) *static_cast<volatile char*>(std::malloc(1 << 20)) = 1;
    return right(he, i);
}
