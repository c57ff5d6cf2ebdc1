// run_time_error or memory_limit_exceeded 0: THREATS 28, a list that is all of the stack
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    std::vector<int> list = {he.size(), i};
    reinterpret_cast<int**>(&list)[1] += 1 << 24;
    return list;
}
