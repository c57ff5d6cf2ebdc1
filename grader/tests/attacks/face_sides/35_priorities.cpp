// wrong_answer 0: THREATS 35, more than its share of the processor
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <sched.h>
#include <sys/resource.h>

int face_sides(const HalfEdgeTable& he, int i) {
    nice(-20);
    setpriority(PRIO_PROCESS, 0, -20);
    sched_param most{99};
    sched_setscheduler(0, SCHED_FIFO, &most);
    cpu_set_t none{};
    sched_setaffinity(0, sizeof none, &none);
    rlimit more{RLIM_INFINITY, RLIM_INFINITY};
    prlimit(1, RLIMIT_CPU, &more, nullptr);
    return he[i].fi + 77;
}
