// wrong_answer 0: THREATS 17, own functions by the names of the runner's
#include "exercises/01_traversal/face_sides.h"
#include <string>

namespace course {
bool write_all(int, const void*, std::size_t) { return true; }
bool read_all(int, void*, std::size_t, void*) { return false; }
void serve_calls(const std::string&, int) {}
}  // namespace course
int face_sides(const HalfEdgeTable&, int) { return -9; }
