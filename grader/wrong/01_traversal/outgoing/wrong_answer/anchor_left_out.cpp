// Begins with the half-edge after the anchor and stops before it.
// Hint: You leave out the half-edge that you start from.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    for (i = he[he[start].opp].next; i != start; i = he[he[i].opp].next)
        result.push_back(i);
    return result;
}
