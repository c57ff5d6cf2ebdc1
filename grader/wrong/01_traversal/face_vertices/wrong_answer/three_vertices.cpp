// Takes every face for a triangle.
// Hint: You take every face for a triangle.
#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int j = he[i].next;
    int k = he[j].next;
    return {he[i].vi, he[j].vi, he[k].vi};
}
