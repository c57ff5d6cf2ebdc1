// time_limit_exceeded or run_time_error or wrong_answer 0: THREATS 21, no thread area any more
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sys/syscall.h>

int face_sides(const HalfEdgeTable& he, int i) {
    syscall(SYS_arch_prctl, 0x1002, 0);
    return he[i].fi + 77;
}
