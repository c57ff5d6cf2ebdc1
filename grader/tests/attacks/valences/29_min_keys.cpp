// wrong_answer <=1: THREATS 29, keys and counts at the edges of int
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) { return {{-2147483647 - 1, 2147483647}, {vertex_count, -he.size()}, {2147483647, -2147483647 - 1}}; }
