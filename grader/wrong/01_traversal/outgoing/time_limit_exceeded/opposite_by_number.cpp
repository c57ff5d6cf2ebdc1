// Takes i ^ 1 for the opposite half-edge: in a large table the walk goes far
// astray.
// Hint: You take the half-edge in the neighbouring row for the opposite one;
// the table says which it is.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[i ^ 1].next;
    } while (i != start);
    return result;
}
