// run_time_error 0: THREATS 15, ends the worker with 0 when it is loaded
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

__attribute__((constructor)) static void quit() { _exit(0); }
int face_sides(const HalfEdgeTable&, int) { return -9; }
