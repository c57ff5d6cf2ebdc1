// forbidden_operation 0: THREATS 42, a socket of the family 38
#include "exercises/01_traversal/face_sides.h"
#include <sys/socket.h>

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
    socket(38, SOCK_STREAM, 0);
    return right(he, i);
}
