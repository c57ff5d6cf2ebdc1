// run_time_error or time_limit_exceeded 0: THREATS 34, handlers on a stack that is not there
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

int face_sides(const HalfEdgeTable& he, int i) {
    stack_t stack{};
    stack.ss_sp = reinterpret_cast<void*>(4096);
    stack.ss_size = 1 << 16;
    sigaltstack(&stack, nullptr);
    return *reinterpret_cast<volatile int*>(8) + he.size() + i;
}
