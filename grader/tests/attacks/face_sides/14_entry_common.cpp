// compile_error or wrong_answer or run_time_error 0: THREATS 14, the entry is a common symbol
#include "exercises/01_traversal/face_sides.h"

asm(".comm course_entry, 4096, 32");
int face_sides(const HalfEdgeTable&, int) { return -9; }
