// Collects the loop in a set: the order is that of the table.
// Hint: Your half-edges are the right ones, in the order of the table and not
// of the walk.
#include "exercises/02_border/boundary_walk.h"

#include <set>

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::set<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    while (he[i].fi == -1 && walk.insert(i).second) i = he[i].next;
    return {walk.begin(), walk.end()};
}
