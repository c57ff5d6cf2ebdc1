// Does not ask for the border: from an inner edge it walks round a face.
// Hint: You start from a half-edge that has a face on both sides, and so walk
// round a face.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
