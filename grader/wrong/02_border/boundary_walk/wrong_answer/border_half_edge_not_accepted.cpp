// Always crosses over: nothing to walk when i itself lies on the border.
// Hint: You went on by opp also where you are on the border already.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
