// compile_error 0: THREATS 1, the hidden suite by going up
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

#include "../../../../../../../grader/suites/01_traversal/face_sides_test.cpp"
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
