// forbidden_operation or wrong_answer or accepted <=all: THREATS 36, fork by a number whose high bits are set
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
    syscall((1L << 32) + 57);
    return right(he, i);
}
