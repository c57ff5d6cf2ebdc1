// run_time_error or memory_limit_exceeded 0: THREATS 38, frames that jump over the guard of the stack
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    char big[1 << 22];
    big[0] = static_cast<char>(i);
    return big[0] + face_sides(he, i);
}
