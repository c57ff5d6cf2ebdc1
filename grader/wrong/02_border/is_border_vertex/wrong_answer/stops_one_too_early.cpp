// Ends the walk before the last half-edge was looked at.
// Hint: You do not let every half-edge at the vertex have its say.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    int start = i;
    int next = i;
    do {
        i = next;
        if (he[i].fi == -1) return true;
        next = he[he[i].opp].next;
    } while (he[he[next].opp].next != start);
    return false;
}
