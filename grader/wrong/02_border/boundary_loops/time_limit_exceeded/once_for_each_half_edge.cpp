// Lists each loop once for each of its half-edges.
// Hint: You list the same loop several times.
#include "exercises/02_border/boundary_loops.h"

namespace {

std::vector<int> walk_from(const HalfEdgeTable& he, int start) {
    std::vector<int> loop;
    int i = start;
    do {
        loop.push_back(i);
        i = he[i].next;
    } while (i != start);
    return loop;
}

}  // namespace

std::vector<std::vector<int>> boundary_loops(const HalfEdgeTable& he) {
    std::vector<std::vector<int>> loops;
    for (int i = 0; i < he.size(); ++i)
        if (he[i].fi == -1) loops.push_back(walk_from(he, i));
    return loops;
}
