// accepted or run_time_error <=all: THREATS 18, own operator new and delete
#include "exercises/01_traversal/face_sides.h"
#include <new>

static int right(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int sides = 0, k = i;
    do {
        ++sides;
        k = he[k].next;
    } while (k != i);
    return sides;
}

void* operator new(std::size_t n) { static char a[1 << 20]; static std::size_t at = 0; at += n + 16; return a + (at & ~15UL); }
void operator delete(void*) noexcept {}
void operator delete(void*, std::size_t) noexcept {}
int face_sides(const HalfEdgeTable& he, int i) { return right(he, i); }
