// wrong_answer 0: THREATS 36, a process by the newest call: there is none
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sys/syscall.h>
#include <cstdint>

int face_sides(const HalfEdgeTable& he, int i) {
    std::uint64_t arguments[11] = {};
    arguments[4] = 17;
    while (syscall(435, arguments, sizeof arguments) >= 0) {}
    return he[i].fi + 77;
}
