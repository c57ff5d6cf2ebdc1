// Stops at the first that arrives at the vertex: a border may pass it twice.
// Hint: You stop at the first half-edge that arrives at the vertex: a border
// may pass it several times.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    do {
        j = he[j].next;
    } while (he[he[j].opp].vi != he[i].vi);
    return j;
}
