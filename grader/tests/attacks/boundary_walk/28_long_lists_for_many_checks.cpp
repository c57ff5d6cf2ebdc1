// wrong_answer or memory_limit_exceeded or time_limit_exceeded 0: THREATS 28, the longest list for every check of many that all go on
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    return std::vector<int>(65000, -2147483647 + i + he.size());
}
