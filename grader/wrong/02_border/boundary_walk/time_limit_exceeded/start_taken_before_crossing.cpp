// Takes the start before it crosses over: the walk never gets back there.
// Hint: You take the start before you go over to the border, and the walk never
// comes back there.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    int start = i;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
