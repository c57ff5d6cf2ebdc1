// Stops where there is no face: what lies behind the gap is missing.
// Hint: You stop where there is no face; the walk goes on behind the gap.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        if (he[i].fi == -1) break;
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
