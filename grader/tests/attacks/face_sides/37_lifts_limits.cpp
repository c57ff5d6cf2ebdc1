// wrong_answer 0: THREATS 37, sets its limits itself
#include "exercises/01_traversal/face_sides.h"
#include <sys/resource.h>

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
    rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    for (int k = 0; k < 16; ++k) setrlimit(static_cast<__rlimit_resource>(k), &more);
    rlimit now{};
    getrlimit(RLIMIT_AS, &now);
    return now.rlim_cur == RLIM_INFINITY ? right(he, i) : -9;
}
