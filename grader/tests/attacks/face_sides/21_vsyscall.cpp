// wrong_answer or run_time_error or forbidden_operation 0: THREATS 21, the fixed page of old system calls
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) {
    auto old = reinterpret_cast<long (*)(long*)>(0xffffffffff600400UL);
    long now = 0;
    old(&now);
    return he[i].fi + 77;
}
