// wrong_answer 0: THREATS 16, the handle of the object and its destructors by own names
#include "exercises/01_traversal/face_sides.h"

extern "C" void __cxa_finalize(void*) { for (;;) {} }
extern "C" int __cxa_atexit(void (*)(void*), void*, void*) { return 0; }
struct Late { ~Late() { for (;;) {} } } late;
int face_sides(const HalfEdgeTable&, int) { return -9; }
