// Repairs the step, but takes out the line that crosses to the border.
// Hint: The step is right now, but you do not get from a face to the border any
// more.
#include "exercises/02_border/boundary_walk_bug.h"

std::vector<int> boundary_walk_bug(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        i = he[i].next;
        walk.push_back(i);
    } while (i != start);
    return walk;
}
