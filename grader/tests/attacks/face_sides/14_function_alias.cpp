// wrong_answer 0: THREATS 14, the function is another one by an alias
#include "exercises/01_traversal/face_sides.h"

extern "C" int one() { return -1; }
int face_sides(const HalfEdgeTable&, int) __attribute__((alias("one")));
