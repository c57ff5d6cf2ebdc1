#include "exercises/00_table/tip.h"

// 终点: the next half-edge starts there
int tip(const HalfEdgeTable& he, int i) {
    int j = he[i].next
    return he[j].vi;
}
