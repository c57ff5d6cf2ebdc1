// Leaves a face out only when it was met just before.
// Hint: You list a face several times that shares several edges.
#include "exercises/01_traversal/adjacent_faces.h"

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::vector<int> faces;
    do {
        int fj = he[he[i].opp].fi;
        if (fj != -1 && fj != fi && (faces.empty() || faces.back() != fj))
            faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    if (faces.size() > 1 && faces.front() == faces.back()) faces.pop_back();
    return faces;
}
