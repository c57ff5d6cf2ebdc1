// Leaves the loop with an answer in its first round.
#include "exercises/04_topology/is_closed.h"

bool is_closed(const HalfEdgeTable& he) {
    for (int i = 0; i < he.size(); ++i)
        return he[i].fi != -1;
    return true;
}
