// Takes it for open where there is no opposite half-edge; there always is one.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].opp == -1) return false;
    return true;
}
