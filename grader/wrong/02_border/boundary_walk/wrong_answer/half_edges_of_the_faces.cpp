// Lists the half-edges on the faces' side of the border.
// Hint: You list half-edges that have a face, on the other side of the border.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(he[i].opp);
        i = he[i].next;
    } while (i != start);
    return walk;
}
