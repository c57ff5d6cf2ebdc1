// Has the start at both ends of the list.
// Hint: You list the start at both ends.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    walk.push_back(i);
    do {
        i = he[i].next;
        walk.push_back(i);
    } while (i != start);
    return walk;
}
