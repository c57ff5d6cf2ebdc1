// forbidden_operation 0: THREATS 36, a program by its descriptor
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
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
    char* none[] = {nullptr};
    fexecve(open("/worker", O_RDONLY), none, none);
    return right(he, i);
}
