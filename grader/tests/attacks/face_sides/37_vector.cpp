// memory_limit_exceeded 0: THREATS 37, a vector of 100 GB
#include "exercises/01_traversal/face_sides.h"

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
    std::vector<int> v(25'000'000'000);
    return v[static_cast<std::size_t>(i)];
    return right(he, i);
}
