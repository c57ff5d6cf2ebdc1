// Leaves a face out only when it was met just before.
// Hint: You list a face several times that the walk meets several times.
#include "exercises/01_traversal/vertex_faces.h"

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        int fi = he[i].fi;
        if (fi != -1 && (faces.empty() || faces.back() != fi))
            faces.push_back(fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
