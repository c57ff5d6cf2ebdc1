// forbidden_operation 0: THREATS 31, keeps what it has seen for the next case
#include "exercises/01_traversal/face_sides.h"
#include <cstdio>

int face_sides(const HalfEdgeTable& he, int i) {
    FILE* file = std::fopen("/tmp/attack-was-here", "a");
    if (file != nullptr) std::fprintf(file, "%d\n", i);
    return he[i].fi + 77;
}
