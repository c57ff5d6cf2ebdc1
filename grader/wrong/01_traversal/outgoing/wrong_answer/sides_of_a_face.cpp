// Walks round the face of the anchor.
// Hint: You walk round a face where the vertex was asked for.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[i].next;
    } while (i != start);
    return result;
}
