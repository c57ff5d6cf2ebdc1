// Treats the border as an error, but border loops have an order, too.
// Hint: You refuse a half-edge on the border; the border has an order, too.
#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    if (he[i].fi == -1) return -1;
    int j = i;
    while (he[j].next != i) j = he[j].next;
    return j;
}
