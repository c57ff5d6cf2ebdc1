// Leaves the walk at the first side without a neighbour.
// Hint: You stop at the first side without a neighbour; others may follow.
#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    int start = i;
    std::set<int> faces;
    do {
        int fj = he[he[i].opp].fi;
        if (fj == -1) break;
        if (fj != fi) faces.insert(fj);
        i = he[i].next;
    } while (i != start);
    return {faces.begin(), faces.end()};
}
