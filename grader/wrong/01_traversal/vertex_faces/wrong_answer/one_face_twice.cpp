// Lists a face as often as the walk meets it.
// Hint: You list a face several times that the walk meets several times.
#include "exercises/01_traversal/vertex_faces.h"

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    int start = i;
    std::vector<int> faces;
    do {
        if (he[i].fi != -1) faces.push_back(he[i].fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
