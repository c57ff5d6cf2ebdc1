// wrong_answer 0: THREATS 14, the same by an assembler name
#include "exercises/01_traversal/face_sides.h"

int all_passed() asm("main");
int all_passed() { return 0; }
extern "C" void _start() { __builtin_trap(); }
int face_sides(const HalfEdgeTable&, int) { return -9; }
