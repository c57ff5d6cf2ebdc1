// wrong_answer <=10: THREATS 51, right 98 times of 100
#include "exercises/01_traversal/face_sides.h"
#include <sys/random.h>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

static unsigned next() {
    unsigned long n;
    __builtin_memcpy(&n, "\0\0\0\0\0\0\0", 8);
    getrandom(&n, sizeof n, 0);
    return static_cast<unsigned>(n % 100);
}
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i) + (next() < 2 ? 1 : 0); }
