// Looks for the half-edges of v in the whole table.
// Hint: You look through the whole table: the half-edges of a vertex are a few
// steps apart.
#include "exercises/01_traversal/outgoing.h"

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    std::vector<int> result;
    if (anchors.vertex[v] == -1) return result;
    for (int k = 0; k < he.size(); k++)
        if (he[k].vi == v) result.push_back(k);
    return result;
}
