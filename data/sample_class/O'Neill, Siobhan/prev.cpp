#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int p = he[i].next;
    // one lap, stop just before we're home
    while (he[p].next != i) {
        p = he[p].next;
    }
    return p;
}
