// run_time_error 0: THREATS 18, own exit and abort
#include "exercises/01_traversal/face_sides.h"

extern "C" void exit(int) { for (;;) {} }
#include <csignal>
int face_sides(const HalfEdgeTable& he, int i) { raise(SIGABRT); return 0; }
