#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        if (he[i].fi == -1) return true;
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    return false;
}
