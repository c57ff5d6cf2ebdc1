// Asks for two different numbers beside an edge, and -1 is one of them.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == he[he[i].opp].fi) return false;
    return true;
}
