// memory_limit_exceeded 0: THREATS 37, a reply of 50 MB
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) { return std::vector<int>(12'500'000, i + he.size()); }
