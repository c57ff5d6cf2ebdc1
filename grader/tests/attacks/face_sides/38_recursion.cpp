// run_time_error 0: THREATS 38, recursion without an end
#include "exercises/01_traversal/face_sides.h"

int face_sides(const HalfEdgeTable& he, int i) { return 1 + face_sides(he, i); }
