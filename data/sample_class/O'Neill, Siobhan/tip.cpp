#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    int next = he[i].next;
    return he[next].vi;
}
