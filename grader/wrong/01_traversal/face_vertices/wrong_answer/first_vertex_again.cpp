// Closes the list with the first vertex.
// Hint: You list the start at both ends.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);

    vertices.push_back(he[start].vi);
    return vertices;
}
