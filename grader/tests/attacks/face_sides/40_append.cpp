// wrong_answer or forbidden_operation 0: THREATS 40, opens its own file to append, by flags alone
#include "exercises/01_traversal/face_sides.h"
#include <fcntl.h>
#include <unistd.h>

int face_sides(const HalfEdgeTable& he, int i) {
    const int fd = open("/submission.so", O_APPEND | O_NONBLOCK);
    write(fd, "attack-was-here", 15);
    return he[i].fi + 77;
}
