// There is one mistake in this function. One changed line repairs it.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    if (he[i].fi != -1) i = he[i].opp;  // cross to the other side
    if (he[i].fi != -1) return {};      // a face there, too: no border
    std::vector<int> walk;
    int start = i;
    // TODO(student): say aloud which variable each line reads and writes.
    do {
        int i = he[i].next;
        walk.push_back(i);
    } while (i != start);
    return walk;
}
