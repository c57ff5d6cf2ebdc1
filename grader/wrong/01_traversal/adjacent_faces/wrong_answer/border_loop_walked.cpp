// Does not ask whether i has a face: lists the faces along the border.
// Hint: Look again at what you do with a half-edge that has no face: you go on
// along the border as if it were one.
#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    int start = i;
    std::vector<int> faces;

    do {
        int fj = he[he[i].opp].fi;
        bool known = std::find(faces.begin(), faces.end(), fj) != faces.end();
        if (fj != -1 && fj != fi && !known) faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    return faces;
}
