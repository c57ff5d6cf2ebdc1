// wrong_answer 0: THREATS 17, own functions by the names of the system's
#include "exercises/01_traversal/face_sides.h"

extern "C" long write(int, const void*, unsigned long n) { return static_cast<long>(n); }
extern "C" long read(int, void*, unsigned long) { return 0; }
extern "C" void* memcpy(void* to, const void*, unsigned long) { return to; }
int face_sides(const HalfEdgeTable&, int) { return -9; }
