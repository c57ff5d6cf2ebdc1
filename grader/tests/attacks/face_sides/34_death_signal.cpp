// wrong_answer 0: THREATS 34, asks not to end with its parent
#include "exercises/01_traversal/face_sides.h"
#include <sys/prctl.h>

int face_sides(const HalfEdgeTable& he, int i) {
    prctl(PR_SET_PDEATHSIG, 0);
    prctl(PR_SET_DUMPABLE, 1);
    prctl(PR_SET_NO_NEW_PRIVS, 0);
    prctl(PR_SET_SECCOMP, 0);
    prctl(PR_SET_TSC, PR_TSC_SIGSEGV);
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    return he[i].fi + 77;
}
