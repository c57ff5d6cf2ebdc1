// wrong_answer 0: THREATS 16, answers from the list of what is called at exit
#include "exercises/01_traversal/face_sides.h"
#include <unistd.h>
#include <cstdlib>

extern "C" int __cxa_atexit(void (*)(void*), void*, void*);
static void late(void*) { write(3, "\x48\x45\x45\x52", 4); }
int face_sides(const HalfEdgeTable& he, int i) {
    __cxa_atexit(late, nullptr, nullptr);
    return -9;
}
