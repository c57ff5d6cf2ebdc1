// Turns round each vertex until a face is missing: that passes by loose edges.
// Hint: You go wrong at loose edges, which are border on both sides.
#include "exercises/02_border/boundary_walk.h"

namespace {

int before(const HalfEdgeTable& he, int i) {
    int k = i;
    while (he[k].next != i) k = he[k].next;
    return k;
}

}  // namespace

std::vector<int> boundary_walk(const HalfEdgeTable& he, int i) {
    std::vector<int> walk;
    if (he[i].fi != -1) i = he[i].opp;
    if (he[i].fi != -1) return walk;
    int start = i;
    do {
        walk.push_back(i);
        i = he[i].opp;
        while (he[i].fi != -1) {
            i = before(he, i);
            i = he[i].opp;
        }
        if (he[i].opp == walk.back()) i = he[i].next;
    } while (i != start && static_cast<int>(walk.size()) <= he.size());
    return walk;
}
