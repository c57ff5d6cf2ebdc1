// forbidden_operation 0: THREATS 20, starts the worker again with LD_PRELOAD
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

int face_sides(const HalfEdgeTable& he, int i) {
    char preload[] = "LD_PRELOAD=/submission.so", worker[] = "/worker", submission[] = "/submission.so";
    char* env[] = {preload, nullptr};
    char* arguments[] = {worker, submission, nullptr};
    execve("/worker", arguments, env);
    return right(he, i);
}
