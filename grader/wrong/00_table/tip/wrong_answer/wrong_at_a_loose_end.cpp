// Where next is opp it believes to be lost, but that is how a loose end looks.
// Hint: You go wrong at the end of a loose edge.
#include "exercises/00_table/tip.h"

int tip(const HalfEdgeTable& he, int i) {
    if (he[i].next == he[i].opp) return -1;
    return he[he[i].next].vi;
}
