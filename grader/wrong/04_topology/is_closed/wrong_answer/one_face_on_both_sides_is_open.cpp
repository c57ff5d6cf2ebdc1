// Asks for two different faces.
// Hint: You take an edge for open that has the same face on both sides.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == he[he[i].opp].fi || he[i].fi == -1) return false;
    return true;
}
