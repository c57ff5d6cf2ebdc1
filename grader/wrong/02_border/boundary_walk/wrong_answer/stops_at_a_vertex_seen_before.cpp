// Stops at the vertex it began at, though the loop goes on from there.
// Hint: You stop at the first vertex when it comes again: a border may pass a
// vertex several times.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int first = he[i].vi;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (he[i].vi != first);
    return walk;
}
