// wrong_answer 0: THREATS 18, hooks of the sanitizers
#include "exercises/01_traversal/face_sides.h"

extern "C" const char* __asan_default_options() { return "exitcode=0:log_path=/tmp/attack-was-here"; }
extern "C" int __lsan_is_turned_off() { return 1; }
int face_sides(const HalfEdgeTable&, int) { return -9; }
