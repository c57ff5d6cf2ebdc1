// Lists a face once for each edge that they share.
// Hint: You list a face several times that shares several edges.
#include "exercises/01_traversal/adjacent_faces.h"

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::vector<int> faces;
    do {
        int fj = he[he[i].opp].fi;
        if (fj != -1 && fj != fi) faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    return faces;
}
