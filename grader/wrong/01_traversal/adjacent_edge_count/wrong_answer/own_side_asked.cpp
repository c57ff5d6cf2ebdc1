// Asks this side for a face, not the other one.
// Hint: You ask this side of the edge for a face, where the other one decides.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        if (he[i].fi != -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
