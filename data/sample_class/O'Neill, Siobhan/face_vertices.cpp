#include "exercises/01_traversal/face_vertices.h"

std::vector<int> face_vertices(const HalfEdgeTable& he, int i) {
    std::vector<int> vs;
    if (he[i].fi == -1) return vs;
    int k = i;
    do {
        k = he[k].next;          // hmm, starts at the second one?
        vs.push_back(he[k].vi);
    } while (k != i);
    return vs;
}
