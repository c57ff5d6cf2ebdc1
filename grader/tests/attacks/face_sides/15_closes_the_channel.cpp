// run_time_error 0: THREATS 15, closes the channel when it is loaded
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

__attribute__((constructor(101))) static void quit() { close(3); }
int face_sides(const HalfEdgeTable&, int) { return -9; }
