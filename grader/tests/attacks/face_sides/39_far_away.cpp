// run_time_error 0: THREATS 39, writes far behind the end of its output
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
    lseek(1, 1L << 40, SEEK_SET);
    write(1, "x", 1);
    return right(he, i);
}
