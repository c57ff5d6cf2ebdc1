// forbidden_operation 0: THREATS 42, counters of the processor
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sys/syscall.h>

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
    char attributes[128] = {};
    syscall(SYS_perf_event_open, attributes, 0, -1, -1, 0);
    return right(he, i);
}
