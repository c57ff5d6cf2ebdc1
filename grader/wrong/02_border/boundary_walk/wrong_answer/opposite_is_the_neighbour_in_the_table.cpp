// Believes that half-edges stand in pairs 0-1, 2-3, and so walks where no
// border is.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/02_border/boundary_walk.h"

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = i % 2 == 0 ? i + 1 : i - 1;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].next;
    } while (i != start);
    return walk;
}
