// Leaves the half-edges out that have no face.
// Hint: You leave out half-edges that have no face.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        if (he[i].fi != -1) result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
