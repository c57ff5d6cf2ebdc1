// Reads the row of the anchor before it asks whether there is one: he[-1].
// Hint: You read the table before you ask whether the vertex has a half-edge at
// all.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    int start = anchors.vertex[v];
    int first = he[start].vi;
    if (start == -1 || first != v) return {};
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    return result;
}
