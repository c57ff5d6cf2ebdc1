#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    int start = he[i].fi;     // first half-edge of the face
    int j = start;
    std::vector<int> result;
    do {
        result.push_back(he[j].vi);
        j = he[j].next;
    } while (j != start);
    return result;
}
