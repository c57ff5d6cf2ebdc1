// Repairs the step, but begins one further and loses an edge.
// Hint: The step is right now, but you leave out an edge at the start.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    i = he[i].next;
    while (i != start) {
        walk.push_back(i);
        i = he[i].next;
    }
    return walk;
}
