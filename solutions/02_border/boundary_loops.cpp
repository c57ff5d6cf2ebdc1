#include "exercises/02_border/boundary_loops.h"

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    std::vector<bool> seen(static_cast<std::size_t>(he.size()), false);
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || seen[static_cast<std::size_t>(start)])
            continue;
        std::vector<int> loop;
        int i = start;
        do {
            loop.push_back(i);
            seen[static_cast<std::size_t>(i)] = true;
            i = he[i].next;
        } while (i != start);
        loops.push_back(loop);
    }
    return loops;
}
