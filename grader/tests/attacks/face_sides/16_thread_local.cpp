// wrong_answer 0: THREATS 16, a thread variable with a destructor
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>

struct Late { int n = 0; ~Late() { write(3, "late", 4); } };
thread_local Late late;
int face_sides(const HalfEdgeTable& he, int i) { return -9 - late.n; }
