#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    int j = he[i].next;
    return he[j].vi;
}
