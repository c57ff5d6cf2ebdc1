// Goes one half-edge too far: the tip of next, not of i.
// Hint: You go one half-edge too far.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    int j = he[i].next;
    return he[he[j].opp].vi;
}
