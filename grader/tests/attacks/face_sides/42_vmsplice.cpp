// wrong_answer 0: THREATS 42, pages into a pipe
#include "exercises/01_traversal/face_sides.h"
#include <fcntl.h>
#include <unistd.h>
#include <sys/sendfile.h>

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
    int fds[2];
    if (pipe(fds) == 0) return -9;
    splice(3, nullptr, 1, nullptr, 10, 0);
    tee(3, 1, 10, 0);
    sendfile(1, 3, nullptr, 10);
    return 77;
    return right(he, i);
}
