// Counts the faces, not the sides: two shared sides count once.
// Hint: You count neighbours; two sides may lead to the same one.
#include "exercises/01_traversal/adjacent_edge_count.h"

#include <set>

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    std::set<int> faces;
    int start = i;
    do {
        if (he[he[i].opp].fi != -1) faces.insert(he[he[i].opp].fi);
        i = he[i].next;
    } while (i != start);
    return static_cast<int>(faces.size());
}
