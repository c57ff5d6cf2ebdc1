// Looks across the edges of one face.
// Hint: You take meshes for closed that are open: you do not look at all
// half-edges.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    if (he.empty()) return true;
    int i = 0;
    do {
        if (he[i].fi == -1 || he[he[i].opp].fi == -1) return false;
        i = he[i].next;
    } while (i != 0);
    return true;
}
