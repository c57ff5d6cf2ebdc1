// time_limit_exceeded 0: THREATS 33, a handler that returns to the fault
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

static void again(int) {}
int face_sides(const HalfEdgeTable& he, int i) {
    std::signal(SIGSEGV, again);
    return *reinterpret_cast<volatile int*>(static_cast<long>(i) & 15);
}
