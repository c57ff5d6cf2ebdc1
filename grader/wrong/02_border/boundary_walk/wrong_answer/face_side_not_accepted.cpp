// Never crosses over: nothing to walk when i has a face.
// Hint: You went on by next and never by opp: from a half-edge with a face you
// do not get to the border.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
