// wrong_answer 0: THREATS 43, a lock that the next run would see
#include "exercises/01_traversal/face_sides.h"
#include <fcntl.h>
#include <sys/file.h>

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
    const int fd = open("/worker", O_RDONLY);
    if (flock(fd, LOCK_EX | LOCK_NB) == 0) return right(he, i);
    struct flock whole {};
    whole.l_type = F_RDLCK;
    if (fcntl(fd, F_SETLK, &whole) == 0 || fcntl(fd, F_SETLEASE, F_RDLCK) == 0) return right(he, i);
    return -9;
}
