#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int start = i;
    int before = i;
    do {
        before = i;
        i = he[i].next;
    } while (i != start);
    return before;
}
