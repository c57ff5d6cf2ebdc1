// Takes the anchor of face v for that of vertex v.
// Hint: You take the anchor of a face for that of a vertex.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.face[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
