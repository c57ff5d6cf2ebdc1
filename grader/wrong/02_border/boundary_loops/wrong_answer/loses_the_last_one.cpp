// Ends each loop one half-edge before it is back.
// Hint: You leave out a half-edge of each loop.
#include "exercises/02_border/boundary_loops.h"

#include <set>

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || seen.count(start) > 0) continue;
        std::vector<int> loop;
        int i = start;
        for (; he[i].next != start; i = he[i].next) {
            seen.insert(i);
            loop.push_back(i);
        }
        seen.insert(i);
        loops.push_back(loop);
    }
    return loops;
}
