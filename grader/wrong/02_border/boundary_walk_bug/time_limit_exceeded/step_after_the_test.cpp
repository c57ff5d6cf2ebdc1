// Compares with a start that the walk only touches in between.
// Hint: You wait for a start that your walk never meets.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = he[i].opp;
    do {
        i = he[i].next;
        walk.push_back(i);
    } while (i != start);
    return walk;
}
