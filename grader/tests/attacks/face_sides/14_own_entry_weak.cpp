// wrong_answer 0: THREATS 14, a weak course_entry
#include "exercises/01_traversal/face_sides.h"

extern "C" __attribute__((weak)) const long course_entry[4] = {0, 0, 0, 0};
int face_sides(const HalfEdgeTable&, int) { return -9; }
