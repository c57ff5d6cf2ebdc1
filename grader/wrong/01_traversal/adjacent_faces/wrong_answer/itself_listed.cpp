// Lists the face as a neighbour of itself.
// Hint: You list the face as a neighbour of itself.
#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return {};
    int start = i;
    std::vector<int> faces;

    do {
        int fj = he[he[i].opp].fi;
        bool known = std::find(faces.begin(), faces.end(), fj) != faces.end();
        if (fj != -1 && !known) faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    return faces;
}
