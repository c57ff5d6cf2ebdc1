// wrong_answer or run_time_error 0: THREATS 37, takes memory in the file that it prints into
#include "exercises/01_traversal/face_sides.h"
#include <sys/mman.h>
#include <unistd.h>
#include <fcntl.h>

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
    static char* at = static_cast<char*>(mmap(nullptr, 1 << 26, PROT_READ | PROT_WRITE, MAP_SHARED, 1, 0));
    for (long k = 0; k < 200; ++k) pwrite(1, "x", 1, k << 24);
    fallocate(1, 0, 0, 1L << 30);
    if (at != MAP_FAILED && at[1 << 25] == 1) return right(he, i);
    return -9;
}
