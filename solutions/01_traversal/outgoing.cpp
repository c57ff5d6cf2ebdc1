#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    int start = anchors.vertex[static_cast<std::size_t>(v)];
    if (start == -1) return {};
    std::vector<int> half_edges;
    int i = start;
    do {
        half_edges.push_back(i);
        i = he[i].opp;
        i = he[i].next;
    } while (i != start);
    return half_edges;
}
