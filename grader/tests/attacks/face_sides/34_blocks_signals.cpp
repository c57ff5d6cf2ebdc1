// time_limit_exceeded 0: THREATS 34, blocks all signals and spins
#include "exercises/01_traversal/face_sides.h"
#include <csignal>

int face_sides(const HalfEdgeTable& he, int i) {
    sigset_t all;
    sigfillset(&all);
    sigprocmask(SIG_BLOCK, &all, nullptr);
    for (int s = 1; s < 65; ++s) std::signal(s, SIG_IGN);
    for (;;) i = i + he.size();
}
