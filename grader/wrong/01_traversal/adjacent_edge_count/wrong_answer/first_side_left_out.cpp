// Begins with the side after i and stops before it.
// Hint: You leave out the side that you start from.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int count = 0;
    for (int j = he[i].next; j != i; j = he[j].next)
        if (he[he[j].opp].fi != -1) count++;
    return count;
}
