// wrong_answer 0: THREATS 31, keeps what it has seen in the file that it prints into
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
    char seen[64] = {};
    pread(1, seen, sizeof seen, 0);
    if (seen[0] == 'x') return right(he, i);
    write(1, "yyyyyyyy", 8);
    return -9;
}
