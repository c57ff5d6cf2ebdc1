// run_time_error or wrong_answer 0: THREATS 18, own code for exceptions
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

extern "C" void __cxa_throw(void*, void*, void (*)(void*)) { _exit(0); }
int face_sides(const HalfEdgeTable& he, int i) { throw 1; }
