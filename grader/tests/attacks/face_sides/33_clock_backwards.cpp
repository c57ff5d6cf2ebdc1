// time_limit_exceeded 0: THREATS 33, sets the clock
#include "exercises/01_traversal/face_sides.h"
#include <ctime>
#include <sys/time.h>

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
    timespec t{1, 0};
    clock_settime(CLOCK_REALTIME, &t);
    timeval now{1, 0};
    settimeofday(&now, nullptr);
    for (;;) {}
    return right(he, i);
}
