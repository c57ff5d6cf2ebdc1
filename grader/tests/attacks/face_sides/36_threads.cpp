// forbidden_operation 0: THREATS 36, threads
#include "exercises/01_traversal/face_sides.h"
#include <pthread.h>

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
    for (int k = 0; k < 1000; ++k) {
        pthread_t thread;
        pthread_create(&thread, nullptr, [](void*) -> void* { for (;;) {} }, nullptr);
    }
    return right(he, i);
}
