// Takes a half-edge for border only if a face is across.
// Hint: You take a half-edge for border only where a face is across; edges may
// have none at all.
#include "exercises/02_border/boundary_loops.h"

#include <set>

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || he[he[start].opp].fi == -1) continue;
        if (seen.count(start) > 0) continue;
        std::vector<int> loop;
        for (int i = start; seen.insert(i).second; i = he[i].next)
            loop.push_back(i);
        loops.push_back(loop);
    }
    return loops;
}
