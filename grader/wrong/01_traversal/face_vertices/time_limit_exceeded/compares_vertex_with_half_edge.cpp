// Compares a vertex with a half-edge: the walk ends by chance or never.
// Hint: You compare the number of a vertex with that of a half-edge.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (he[i].vi != start);
    return vertices;
}
