// Turns round the vertex and waits for one that arrives: all of them leave.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    do {
        j = he[j].opp;
        j = he[j].next;
    } while (he[j].next != i);
    return j;
}
