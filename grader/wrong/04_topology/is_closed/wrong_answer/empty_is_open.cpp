// Says that an empty mesh is open.
// Hint: You take a mesh without edges for open.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) return false;
    return !he.empty();
}
