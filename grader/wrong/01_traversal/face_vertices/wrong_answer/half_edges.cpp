// Lists half-edges, not their vertices.
// Hint: You list half-edges where vertices were asked for.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        vertices.push_back(i);
        i = he[i].next;
    } while (i != start);
    return vertices;
}
