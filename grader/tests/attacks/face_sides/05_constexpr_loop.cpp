// compile_error 0: THREATS 5, a constant expression without an end
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

constexpr long spin() {
    long n = 0;
    for (long k = 0; k < (1L << 60); ++k) n += k % 7;
    return n;
}
static_assert(spin() != 1);
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
