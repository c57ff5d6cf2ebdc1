// run_time_error or wrong_answer or time_limit_exceeded 0: THREATS 21, jumps out of the call
#include "exercises/01_traversal/face_sides.h"
#include <csetjmp>

static jmp_buf back;
__attribute__((constructor)) static void mark() { if (setjmp(back) != 0) { for (;;) {} } }
int face_sides(const HalfEdgeTable& he, int i) { longjmp(back, i + 1); }
