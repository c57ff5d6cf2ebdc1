// forbidden_operation 0: THREATS 42, uses the channel as a socket
#include "exercises/01_traversal/face_sides.h"
#include <sys/socket.h>

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
    sockaddr_storage to{};
    to.ss_family = AF_UNIX;
    connect(3, reinterpret_cast<sockaddr*>(&to), sizeof to);
    return right(he, i);
}
