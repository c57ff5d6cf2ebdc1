// accepted all: THREATS 25, something can be read from the input; wrong only if it is seen
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

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
    if (read(0, &i, 1) > 0 || read(1, &i, 1) > 0) return -9;
    return right(he, i);
}
