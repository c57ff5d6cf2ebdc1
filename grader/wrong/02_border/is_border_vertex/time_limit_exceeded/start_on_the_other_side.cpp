// Takes the start from the other side: an inner vertex is never done.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = he[i].opp;
    do {
        if (he[i].fi == -1) return true;
        i = he[he[i].opp].next;
    } while (i != start);
    return false;
}
