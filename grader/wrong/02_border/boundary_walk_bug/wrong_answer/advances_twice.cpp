// Adds a second step instead of changing the wrong one: every other edge.
// Hint: You take two steps at once.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        int k = he[i].next;
        walk.push_back(k);
        i = he[k].next;
    } while (i != start && static_cast<int>(walk.size()) < he.size());
    return walk;
}
