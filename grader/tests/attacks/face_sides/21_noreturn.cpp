// run_time_error or wrong_answer 0: THREATS 21, no return statement
#include "exercises/01_traversal/face_sides.h"

#pragma GCC diagnostic ignored "-Wreturn-type"
int face_sides(const HalfEdgeTable&, int) {}
