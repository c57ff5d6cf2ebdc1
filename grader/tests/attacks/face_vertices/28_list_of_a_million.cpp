// memory_limit_exceeded 0: THREATS 28, a list of a million numbers
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    return std::vector<int>(1'000'000, he.size() + i);
}
