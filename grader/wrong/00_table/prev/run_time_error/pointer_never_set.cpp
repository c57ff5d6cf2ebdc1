// Keeps a pointer to the half-edge before, and reads it when there is none.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    const HalfEdge* before = nullptr;
    int start = i;
    do {
        if (before != nullptr && before->next == start) break;
        i = he[i].next;
    } while (i != start);
    return he[before->opp].opp;
}
