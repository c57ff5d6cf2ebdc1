// compile_error 0: THREATS 14, the function is declared and not there
#include "exercises/01_traversal/face_sides.h"

int face_sidez(const HalfEdgeTable&, int) { return 0; }
