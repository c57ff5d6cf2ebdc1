// Does not ask whether there is a face: lists the border loop.
// Hint: Look again at what you do with a half-edge that has no face: you go on
// along the border as if it were one.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> vertices;
    do {
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return vertices;
}
