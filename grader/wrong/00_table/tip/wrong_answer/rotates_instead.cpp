// Goes to opp and then to next: that half-edge leaves the vertex of i.
// Hint: You give the vertex that the half-edge leaves.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    i = he[i].opp;
    i = he[i].next;
    return he[i].vi;
}
