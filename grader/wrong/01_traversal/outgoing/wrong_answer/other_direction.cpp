// The right half-edges, but the other way round.
// Hint: Your answers are the right ones, but the other way round.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.insert(result.begin(), i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
