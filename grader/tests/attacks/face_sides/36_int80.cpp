// forbidden_operation 0: THREATS 36, a process by the call of 32-bit programs
#include "exercises/01_traversal/face_sides.h"

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
    int number = 2;
    asm volatile("int $0x80" : "+a"(number) : : "memory");
    return right(he, i);
}
