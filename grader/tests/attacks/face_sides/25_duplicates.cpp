// wrong_answer 0: THREATS 25, channel and output change places
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <fcntl.h>

int face_sides(const HalfEdgeTable& he, int i) {
    dup2(1, 3);
    dup2(3, 1);
    fcntl(3, F_DUPFD, 100);
    fcntl(3, F_SETFL, O_NONBLOCK | O_ASYNC);
    fcntl(3, F_SETOWN, 1);
    return -9;
}
