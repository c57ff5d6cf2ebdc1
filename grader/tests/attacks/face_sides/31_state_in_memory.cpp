// wrong_answer 0: THREATS 31, keeps what it has seen in a mapping shared with the next worker
#include "exercises/01_traversal/face_sides.h"
#include <sys/mman.h>

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
    void* at = mmap(reinterpret_cast<void*>(0x10000000), 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    static int seen = 0;
    if (at == MAP_FAILED || *static_cast<int*>(at) == 0) {
        if (at != MAP_FAILED) *static_cast<int*>(at) = ++seen;
        return -9;
    }
    return right(he, i);
}
