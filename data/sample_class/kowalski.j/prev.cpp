#include "exercises/00_table/prev.h"

int prev(const HalfEdgeTable& he, int i) {
    int last = -1;
    while (he[last].next != i)
        last = he[last].next;
    return last;
}
