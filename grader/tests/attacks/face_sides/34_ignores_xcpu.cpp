// time_limit_exceeded 0: THREATS 34, a handler for the end of its time
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

static void nothing(int) {}
int face_sides(const HalfEdgeTable& he, int i) {
    std::signal(SIGXCPU, nothing);
    std::signal(SIGTERM, nothing);
    for (;;) i = i + he.size();
}
