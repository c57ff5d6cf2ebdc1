// Goes on by next and opp until there is no face: on a closed mesh for ever.
// Hint: You walk until there is no face, which never happens on a closed mesh.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    if (he.empty()) return true;
    int i = 0;
    while (he[i].fi != -1) i = he[he[i].next].opp;
    return false;
}
