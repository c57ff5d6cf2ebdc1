// Renames the inner variable, and so the walk still stands at its start.
// Hint: You do not move on from the start.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        int k = he[i].next;
        walk.push_back(k);
    } while (i != start);
    return walk;
}
