// Stops one half-edge before the one that is asked for.
// Hint: You give another half-edge of the loop, not the one just before.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[he[j].next].next != i) j = he[j].next;
    return j;
}
