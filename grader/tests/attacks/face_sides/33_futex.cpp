// time_limit_exceeded 0: THREATS 33, waits for a word that nobody changes
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
    int word = 1;
    syscall(SYS_futex, &word, 0, 1, nullptr, nullptr, 0);
    return right(he, i);
}
