// Counts the sides without a neighbour.
// Hint: You count the sides that have no neighbour.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        if (he[he[i].opp].fi == -1) count++;
        i = he[i].next;
    } while (i != start);
    return count;
}
