// Leaves the loop with an answer in its first round.
// Hint: You take meshes for closed that are open: you do not look at all
// half-edges.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        return he[i].fi != -1;
    return true;
}
