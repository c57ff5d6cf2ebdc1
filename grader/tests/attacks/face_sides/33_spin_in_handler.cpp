// time_limit_exceeded 0: THREATS 33, spins in the handler of its own fault
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

static void spin(int) { for (;;) {} }
int face_sides(const HalfEdgeTable& he, int i) {
    std::signal(SIGSEGV, spin);
    return *reinterpret_cast<volatile int*>(i);
}
