// Lists the vertices of the loop instead of its half-edges.
// Hint: You list vertices where half-edges were asked for.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return walk;
}
