// Counts the different vertices of the face.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/01_traversal/face_sides.h"

#include <set>

int face_sides(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    std::set<int> vertices;
    int start = i;
    do {
        vertices.insert(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return static_cast<int>(vertices.size());
}
