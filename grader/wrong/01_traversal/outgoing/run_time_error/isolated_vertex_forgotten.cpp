// Walks from the anchor -1 of an isolated vertex: he[-1].
// Hint: You forgot vertices that have no half-edge at all.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
