// Begins with the smallest vertex, not with that of i.
// Hint: Your vertices are in the right order, but begin at another one.
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

    std::rotate(vertices.begin(),
                std::min_element(vertices.begin(), vertices.end()),
                vertices.end());
    return vertices;
}
