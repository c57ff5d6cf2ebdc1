// time_limit_exceeded or run_time_error 0: THREATS 25, eats the next request
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
    char request[4096];
    read(3, request, sizeof request);
    return right(he, i);
}
