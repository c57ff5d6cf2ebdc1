// Does not ask whether i has a face: counts along the border loop.
// Hint: Look again at what you do with a half-edge that has no face: you go on
// along the border as if it were one.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    int start = i;
    int count = 0;
    do {
        if (he[he[i].opp].fi != -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
