// Turns round the vertex in place of the face.
// Hint: You turn round a vertex where the face was asked for.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        i = he[i].opp;
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return vertices;
}
