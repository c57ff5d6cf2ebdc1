// Begins with the side after i and stops before it.
// Hint: You leave out the side that you start from.
#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    std::set<int> faces;
    for (int j = he[i].next; j != i; j = he[j].next) {
        int fj = he[he[j].opp].fi;
        if (fj != -1 && fj != fi) faces.insert(fj);
    }
    return {faces.begin(), faces.end()};
}
