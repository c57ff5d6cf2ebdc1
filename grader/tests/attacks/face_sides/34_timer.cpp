// wrong_answer 0: THREATS 34, an alarm that answers in the place of the function
#include "exercises/01_traversal/face_sides.h"
#include <csignal>
#include <unistd.h>
#include <sys/time.h>
#include <ctime>

static void late(int) { write(3, "late", 4); }
int face_sides(const HalfEdgeTable& he, int i) {
    std::signal(SIGALRM, late);
    alarm(1);
    itimerval soon{{0, 100}, {0, 100}};
    setitimer(ITIMER_REAL, &soon, nullptr);
    timer_t timer;
    timer_create(CLOCK_MONOTONIC, nullptr, &timer);
    return he[i].fi + 77;
}
