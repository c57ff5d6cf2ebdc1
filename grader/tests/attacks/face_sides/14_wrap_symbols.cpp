// compile_error or wrong_answer or run_time_error 0: THREATS 14, the linker is asked to wrap symbols
#include "exercises/01_traversal/face_sides.h"

extern "C" int __wrap_course_entry[4] = {0, 0, 0, 0};
extern "C" void* __real_course_entry = nullptr;
int face_sides(const HalfEdgeTable&, int) { return -9; }
