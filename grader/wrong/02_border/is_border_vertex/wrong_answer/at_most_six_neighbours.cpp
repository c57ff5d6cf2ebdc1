// Takes six steps, as if no vertex had more than six edges.
// Hint: You give up after a few steps; a vertex may have more edges.
#include "exercises/02_border/is_border_vertex.h"

bool is_border_vertex(const HalfEdgeTable& he, int i) {
    for (int k = 0; k < 6; ++k) {
        if (he[i].fi == -1) return true;
        i = he[he[i].opp].next;
    }
    return false;
}
