#include "exercises/00_table/prev.h"

// TODO 明天检查: is it prev(he, i) or prev(i)?
int previous(const HalfEdgeTable& he, int i) {
    int j = i;
    while (he[j].next != i) j = he[j].next;
    return j;
}
