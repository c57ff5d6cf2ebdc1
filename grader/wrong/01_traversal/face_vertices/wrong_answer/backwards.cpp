// Lists the vertices against the direction of next.
// Hint: You list the vertices against the direction of the half-edges.
#include "exercises/01_traversal/face_vertices.h"

#include <algorithm>

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        vertices.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);

    std::reverse(vertices.begin() + 1, vertices.end());
    return vertices;
}
