// Turns round the vertex in place of the face.
// Hint: You turn round a vertex where the face was asked for.
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
        if (fj != -1 && fj != fi && !known) faces.push_back(fj);
        i = he[he[i].opp].next;
    } while (i != start);
    return faces;
}
