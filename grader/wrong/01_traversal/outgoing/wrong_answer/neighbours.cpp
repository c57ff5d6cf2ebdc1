// Lists the vertices at the other ends.
// Hint: You list vertices where half-edges were asked for.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        i = he[i].opp;
        result.push_back(he[i].vi);
        i = he[i].next;
    } while (i != start);
    return result;
}
