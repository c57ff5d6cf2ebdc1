// Lists the -1 of an isolated vertex.
// Hint: You list -1 as a half-edge.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    int start = anchors.vertex[v];
    if (start == -1) return {start};
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
