// forbidden_operation 0: THREATS 35, writes into the launcher
#include "exercises/01_traversal/face_sides.h"
#include <sys/uio.h>
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
    char byte = 0;
    iovec here{&byte, 1}, there{&byte, 1};
    process_vm_writev(getppid(), &here, 1, &there, 1, 0);
    return right(he, i);
}
