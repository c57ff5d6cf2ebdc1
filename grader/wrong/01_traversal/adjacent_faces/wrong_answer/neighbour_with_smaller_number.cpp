// Lists only neighbours with a larger number, as if each pair were wanted once.
// Hint: You leave out neighbours because of their number.
#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::vector<int> faces;

    do {
        int fj = he[he[i].opp].fi;
        bool known = std::find(faces.begin(), faces.end(), fj) != faces.end();
        if (fj > fi && !known) faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    return faces;
}
