// compile_error 0: THREATS 2, #embed of a file
#include "exercises/01_traversal/face_sides.h"

static const char secret[] = {
#embed "/etc/passwd"
};
int face_sides(const HalfEdgeTable& he, int i) { return __builtin_printf("%s", secret); }
