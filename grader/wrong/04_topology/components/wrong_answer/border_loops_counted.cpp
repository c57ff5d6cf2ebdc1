// Takes each border loop for a component, and a closed mesh for one.
// Hint: You tell components by the border; one component may have several
// loops, or none.
#include "exercises/04_topology/components.h"

#include <vector>

int components(const HalfEdgeTable& he) {
    std::vector<bool> seen(static_cast<std::size_t>(he.size()));
    int loops = 0;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || seen[static_cast<std::size_t>(start)])
            continue;
        ++loops;
        int i = start;
        do {
            seen[static_cast<std::size_t>(i)] = true;
            i = he[i].next;
        } while (i != start);
    }
    return loops == 0 && !he.empty() ? 1 : loops;
}
