// Lists the faces that share a vertex, not an edge.
// Hint: You list faces that share only a vertex with this one.
#include "exercises/01_traversal/adjacent_faces.h"

#include <set>

std::vector<int> adjacent_faces(const HalfEdgeTable& he, int i) {
    int fi = he[i].fi;
    if (fi == -1) return {};
    std::set<int> faces;
    int start = i;
    do {
        int j = i;
        do {
            if (he[j].fi != -1 && he[j].fi != fi) faces.insert(he[j].fi);
            j = he[he[j].opp].next;
        } while (j != i);
        i = he[i].next;
    } while (i != start);
    return {faces.begin(), faces.end()};
}
