// run_time_error or time_limit_exceeded 0: THREATS 44, the exceptions of the table with texts of its own
#include "exercises/01_traversal/face_sides.h"
#include <string>

int face_sides(const HalfEdgeTable& he, int i) {
    if (i % 2 == 0) throw OutOfTable(std::string(5000000, '\x1b'));
    throw TooManyReads("<script>alert(" + std::to_string(he.size()) + ")</script>");
}
