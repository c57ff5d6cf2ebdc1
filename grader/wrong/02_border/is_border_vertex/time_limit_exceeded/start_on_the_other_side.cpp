// Takes the start from the other side: an inner vertex is never done.
// Hint: You take the start from the other side, and never come back there.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = he[i].opp;
    do {
        if (he[i].fi == -1) return true;
        i = he[he[i].opp].next;
    } while (i != start);
    return false;
}
