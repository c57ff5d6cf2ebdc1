// wrong_answer 0: THREATS 14, an own main that says that all passed
#include "exercises/01_traversal/face_sides.h"

#include <cstdio>
int main() {
    std::puts("All tests passed (10 assertions in 8 test cases)");
    return 0;
}
int face_sides(const HalfEdgeTable&, int) { return -9; }
