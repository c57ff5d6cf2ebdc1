// forbidden_operation 0: THREATS 25, sends a descriptor to the judge
#include "exercises/01_traversal/face_sides.h"
#include <sys/socket.h>
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
    int fd = open("/worker", O_RDONLY);
    char control[CMSG_SPACE(sizeof fd)] = {}, byte = 0;
    iovec io{&byte, 1};
    msghdr message{};
    message.msg_iov = &io;
    message.msg_iovlen = 1;
    message.msg_control = control;
    message.msg_controllen = sizeof control;
    cmsghdr* head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof fd);
    sendmsg(3, &message, 0);
    return right(he, i);
}
