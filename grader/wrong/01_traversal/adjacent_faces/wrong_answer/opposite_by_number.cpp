// Takes i ^ 1 for the opposite half-edge.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/adjacent_faces.h"

#include <algorithm>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::vector<int> faces;

    do {
        int fj = he[i ^ 1].fi;
        bool known = std::find(faces.begin(), faces.end(), fj) != faces.end();
        if (fj != -1 && fj != fi && !known) faces.push_back(fj);
        i = he[i].next;
    } while (i != start);
    return faces;
}
