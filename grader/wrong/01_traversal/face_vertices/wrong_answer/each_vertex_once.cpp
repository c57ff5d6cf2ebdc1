// Leaves a vertex out that the face passes a second time.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/01_traversal/face_vertices.h"

#include <algorithm>

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> vertices;
    do {
        int vi = he[i].vi;
        if (std::find(vertices.begin(), vertices.end(), vi) == vertices.end())
            vertices.push_back(vi);
        i = he[i].next;
    } while (i != start);
    return vertices;
}
