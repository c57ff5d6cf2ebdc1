// Sorts the list: it is not in the order of the walk any more.
// Hint: Your answers are the right ones, but not in the order of the walk.
#include "exercises/01_traversal/outgoing.h"

#include <algorithm>

std::vector<int> outgoing(const HalfEdgeTable& he, const Anchors& anchors,
                          int v) {
    if (anchors.vertex[v] == -1) return {};
    int start = anchors.vertex[v];
    int i = start;
    std::vector<int> result;

    do {
        result.push_back(i);
        i = he[he[i].opp].next;
    } while (i != start);
    std::sort(result.begin(), result.end());
    return result;
}
