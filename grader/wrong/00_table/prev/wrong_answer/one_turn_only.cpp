// Turns round the vertex one step: right only where two edges meet.
// Hint: You turn one step round the vertex, which is enough only where two
// edges meet.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = he[he[i].opp].next;
    return he[j].opp;
}
