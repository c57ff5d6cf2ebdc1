// Stops when it is at the first vertex again; a face may pass it twice.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int first = he[i].vi;
    std::vector<int> vertices;
    do {
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (he[i].vi != first);
    return vertices;
}
