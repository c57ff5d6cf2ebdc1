// compile_error 0: THREATS 11, the types of the contract by other names
#include "exercises/01_traversal/face_sides.h"

#define HalfEdgeTable int
int face_sides(const HalfEdgeTable& he, int i) { return he + i; }
#undef HalfEdgeTable
#define face_sides other
int face_sides(const HalfEdgeTable& he, int i) { return 1; }
