// wrong_answer 0: THREATS 11, the macros of the suite by other texts
#include "exercises/01_traversal/face_sides.h"

#define REQUIRE(x) true
#define CHECK(x) true
#define TEST_CASE(...) void f()
#define CATCH_CONFIG_MAIN
int face_sides(const HalfEdgeTable&, int) { return -9; }
