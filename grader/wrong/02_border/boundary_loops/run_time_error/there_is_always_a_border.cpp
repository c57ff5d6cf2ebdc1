// Looks for the first border half-edge without a limit.
// Hint: You look for the border of a mesh that has none, and past the end of
// the table.
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
    int i = 0;
    while (he[i].fi != -1) ++i;
    return {walk_from(he, i)};
}
