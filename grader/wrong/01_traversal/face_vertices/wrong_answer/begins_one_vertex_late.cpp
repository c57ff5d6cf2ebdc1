// Steps before it notes the vertex: the first one comes last.
// Hint: You begin at the second vertex; the one that the half-edge leaves
// comes last.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        i = he[i].next;
        vertices.push_back(he[i].vi);
    } while (i != start);
    return vertices;
}
