// Stops when it is at the first vertex again; a face may pass it twice.
// Hint: You end the walk at a vertex that you have seen: a face may pass a
// vertex twice.
#include "exercises/01_traversal/adjacent_edge_count.h"

int adjacent_edge_count(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return 0;
    int first = he[i].vi;
    int count = 0;
    do {
        if (he[he[i].opp].fi != -1) count++;
        i = he[i].next;
    } while (he[i].vi != first);
    return count;
}
