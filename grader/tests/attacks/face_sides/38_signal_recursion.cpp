// run_time_error or time_limit_exceeded or memory_limit_exceeded 0: THREATS 38, a handler of faults that faults
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

static void fault(int) { *reinterpret_cast<volatile int*>(8) = 1; }
int face_sides(const HalfEdgeTable& he, int i) {
    struct sigaction action {};
    action.sa_handler = fault;
    action.sa_flags = SA_NODEFER;
    sigaction(SIGSEGV, &action, nullptr);
    fault(i);
    return he.size();
}
