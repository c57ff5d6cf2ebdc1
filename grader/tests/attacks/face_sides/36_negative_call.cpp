// wrong_answer 0: THREATS 36, system calls that there are not
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sys/syscall.h>

int face_sides(const HalfEdgeTable& he, int i) {
    for (long n : {1000L, 5000L, 334L + 200}) syscall(n, 0, 0, 0);
    return he[i].fi + 77;
}
