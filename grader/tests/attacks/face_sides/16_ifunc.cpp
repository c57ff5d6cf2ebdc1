// forbidden_operation 0: THREATS 16, code that chooses a function at load time
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

extern "C" int (*choose())(const HalfEdgeTable&, int) { fork(); return nullptr; }
int other(const HalfEdgeTable&, int) __attribute__((ifunc("choose")));
int face_sides(const HalfEdgeTable& he, int i) { return other(he, i); }
