// Collects in a set: sorted, not in the order of the face.
// Hint: Your answers are the right ones, but not in the order of the walk.
#include "exercises/01_traversal/face_vertices.h"

#include <set>

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    std::set<int> vertices;
    int start = i;
    do {
        vertices.insert(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return {vertices.begin(), vertices.end()};
}
