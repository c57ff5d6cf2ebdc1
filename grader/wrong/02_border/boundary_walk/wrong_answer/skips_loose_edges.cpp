// Goes on where a face is across: loose edges are left out.
// Hint: You go wrong at loose edges, which are border on both sides.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        if (he[he[i].opp].fi != -1) walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
