// wrong_answer 0: THREATS 41, the newer calls of mount
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sys/syscall.h>

int face_sides(const HalfEdgeTable& he, int i) {
    for (long n = 428; n <= 433; ++n) syscall(n, -1, "", 0, 0, 0);
    syscall(442, -1, "", 0, nullptr, 0);
    return he[i].fi + 77;
}
