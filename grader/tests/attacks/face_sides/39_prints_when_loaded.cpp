// run_time_error 0: THREATS 39, prints without an end when it is loaded
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

struct Print { Print() { for (;;) write(1, "xxxxxxxxxxxxxxxx", 16); } } print;
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
