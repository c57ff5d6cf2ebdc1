// Waits to be back at the first border half-edge, from every loop.
#include "exercises/02_border/boundary_loops.h"

#include <set>

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    int first = 0;
    while (first < he.size() && he[first].fi != -1) ++first;
    for (int i = first; i < he.size(); ++i) {
        if (he[i].fi != -1 || seen.count(i) > 0) continue;
        std::vector<int> loop;
        int k = i;
        do {
            if (seen.insert(k).second) loop.push_back(k);
            k = he[k].next;
        } while (k != first);
        loops.push_back(loop);
    }
    return loops;
}
