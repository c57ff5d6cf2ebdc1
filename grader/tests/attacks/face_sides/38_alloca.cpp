// run_time_error or memory_limit_exceeded or wrong_answer 0: THREATS 38, a frame of a gigabyte
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    volatile char* big = static_cast<char*>(__builtin_alloca(1UL << 30));
    big[0] = static_cast<char>(i);
    return big[0] + he.size() + 1000;
}
