// Collects in a set: sorted, not in the order of the walk.
// Hint: Your answers are the right ones, but not in the order of the walk.
#include "exercises/01_traversal/vertex_faces.h"

#include <set>

std::vector<int> vertex_faces(const HalfEdgeTable& he, int i) {
    std::set<int> faces;
    int start = i;
    do {
        if (he[i].fi != -1) faces.insert(he[i].fi);
        i = he[he[i].opp].next;
    } while (i != start);
    return {faces.begin(), faces.end()};
}
