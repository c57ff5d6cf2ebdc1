// wrong_answer 0: THREATS 16, code at the end of the worker
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

__attribute__((destructor)) static void late() { write(3, "late", 4); fork(); }
int face_sides(const HalfEdgeTable&, int) { return -9; }
