// wrong_answer or compile_error 0: THREATS 14, a course_entry with a version
#include "exercises/01_traversal/face_sides.h"

extern "C" const long mine[4] = {0};
asm(".symver mine, course_entry@@V2");
int face_sides(const HalfEdgeTable&, int) { return -9; }
