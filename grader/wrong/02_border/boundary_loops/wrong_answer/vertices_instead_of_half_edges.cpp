// Lists the vertices of the loops instead of their half-edges.
// Hint: You list vertices where half-edges were asked for.
#include "exercises/02_border/boundary_loops.h"

#include <set>

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    std::set<int> seen;
    for (int start = 0; start < he.size(); ++start) {
        if (he[start].fi != -1 || seen.count(start) > 0) continue;
        std::vector<int> loop;
        for (int i = start; seen.insert(i).second; i = he[i].next)
            loop.push_back(he[i].vi);
        loops.push_back(loop);
    }
    return loops;
}
