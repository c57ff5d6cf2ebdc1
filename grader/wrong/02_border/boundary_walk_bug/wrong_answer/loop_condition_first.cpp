// Turns the loop round: at the start it is already back.
// Hint: You end the walk before it has begun.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    while (i != start) {
        i = he[i].next;
        walk.push_back(i);
    }
    return walk;
}
