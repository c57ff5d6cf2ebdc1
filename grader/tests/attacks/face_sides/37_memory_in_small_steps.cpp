// memory_limit_exceeded 0: THREATS 37, a list that grows until it cannot
#include "exercises/01_traversal/face_sides.h"
#include <map>
#include <vector>

int face_sides(const HalfEdgeTable& he, int i) {
    std::map<int, std::vector<int>> all;
    for (int k = i;; ++k) all[k].assign(1000, he.size());
}
