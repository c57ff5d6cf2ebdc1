// forbidden_operation 0: THREATS 40, a file without a name
#include "exercises/01_traversal/face_sides.h"
#include <fcntl.h>

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
    open("/", O_TMPFILE | O_RDWR, 0666);
    return right(he, i);
}
