// Is true when some face is met: says inside for border and back.
// Hint: You answer the opposite of what was asked.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    do {
        if (he[i].fi == -1) return false;
        i = he[he[i].opp].next;
    } while (i != start);
    return true;
}
