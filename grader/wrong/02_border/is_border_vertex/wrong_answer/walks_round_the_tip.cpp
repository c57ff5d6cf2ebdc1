// Walks next, then opp: that goes round the tip and not round the start.
// Hint: You turn round the vertex where the half-edge arrives, not round the
// one it leaves.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        if (he[i].fi == -1) return true;
        i = he[i].next;
        i = he[i].opp;
    } while (i != start);
    return false;
}
