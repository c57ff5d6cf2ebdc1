// Ends at the next edge without a face: after one step.
// Hint: You end the walk before it is back.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    do {
        i = he[i].next;
        walk.push_back(i);
    } while (he[i].fi != -1);
    return walk;
}
