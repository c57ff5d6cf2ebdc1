// wrong_answer 0: THREATS 42, options of the channel: who is at the other end
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
    char peer[64];
    socklen_t size = sizeof peer;
    if (getsockopt(3, SOL_SOCKET, SO_PEERCRED, peer, &size) == 0) return right(he, i);
    if (getpeername(3, reinterpret_cast<sockaddr*>(peer), &size) == 0) return right(he, i);
    shutdown(3, SHUT_RD);
    return -9;
}
