// Lists the loop backwards.
// Hint: Your answers are the right ones, but the other way round.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.insert(walk.begin(), i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
