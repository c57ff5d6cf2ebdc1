// Takes the double vertex off the end, also where the list is empty.
// Hint: You take something off a list that may be empty.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    std::vector<int> vertices;
    if (he[i].fi != -1) {
        int start = i;
        vertices.push_back(he[i].vi);
        do {
            i = he[i].next;
            vertices.push_back(he[i].vi);
        } while (i != start);
    }
    vertices.pop_back();
    return vertices;
}
