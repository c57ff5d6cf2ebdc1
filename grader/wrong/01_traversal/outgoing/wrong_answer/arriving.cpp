// Lists the half-edges that arrive at the vertex.
// Hint: You list the half-edges that arrive at the vertex.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        i = he[i].opp;
        result.push_back(i);
        i = he[i].next;
    } while (i != start);
    return result;
}
