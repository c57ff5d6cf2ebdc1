// Leaves out the half-edge that it begins with.
// Hint: You leave out the half-edge that you start from.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    for (int k = he[i].next; k != i; k = he[k].next) walk.push_back(k);
    return walk;
}
