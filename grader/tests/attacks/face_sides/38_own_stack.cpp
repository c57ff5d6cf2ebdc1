// memory_limit_exceeded 0: THREATS 38, recursion on a stack of its own
#include "exercises/01_traversal/face_sides.h"

static int deep(const HalfEdgeTable& he, int i) {
    std::vector<int> room(100'000, i);
    return deep(he, i + 1) + room[0];
}
int face_sides(const HalfEdgeTable& he, int i) { return deep(he, i); }
