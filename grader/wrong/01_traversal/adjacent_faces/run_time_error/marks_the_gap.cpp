// Marks the faces that it has seen in an array, -1 too.
// Hint: You use the number of a face as an index, also where there is no face.
#include "exercises/01_traversal/adjacent_faces.h"

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    std::vector<bool> seen(he.size(), false);
    seen[fi] = true;
    int start = i;
    std::vector<int> faces;
    do {
        int fj = he[he[i].opp].fi;
        if (!seen[fj]) faces.push_back(fj);
        seen[fj] = true;
        i = he[i].next;
    } while (i != start);
    return faces;
}
