// wrong_answer or memory_limit_exceeded or time_limit_exceeded <=10: THREATS 28, a map of millions where the table allows it
#include "exercises/01_traversal/valences.h"

std::map<int, int> valences(const HalfEdgeTable& he, int vertex_count) {
    std::map<int, int> all;
    const int n = he.size() > 100'000 ? 2'500'000 : 3;
    for (int k = 0; k < n; ++k) all.emplace_hint(all.end(), k + vertex_count * 0, -2147483647);
    return all;
}
