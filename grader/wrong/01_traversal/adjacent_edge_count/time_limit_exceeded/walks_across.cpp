// Crosses the edge to look at the other side, and stays there.
// Hint: You went over to the other side of the edge and did not come back.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int start = i;
    int count = 0;
    do {
        i = he[i].opp;
        if (he[i].fi != -1) count++;
    } while (i != he[start].next);
    return count;
}
