// Goes on in the neighbour in place of the face.
// Hint: You went over to the neighbour and did not come back.
#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::set<int> faces;
    do {
        i = he[i].opp;
        if (he[i].fi != -1 && he[i].fi != fi) faces.insert(he[i].fi);
        i = he[he[i].next].opp;
        i = he[i].opp;
    } while (i != he[start].opp);
    return {faces.begin(), faces.end()};
}
