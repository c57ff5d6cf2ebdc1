// forbidden_operation 0: THREATS 37, memory that is a file
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
    int fd = static_cast<int>(syscall(SYS_memfd_create, "attack-was-here", 0));
    ftruncate(fd, 1L << 40);
    return right(he, i);
}
